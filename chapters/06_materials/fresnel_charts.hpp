#pragma once
/// @file fresnel_charts.hpp
/// Figures of section 6.8: reflectances against the angle, exact and by Schlick.

#include <fmt/format.h>

#include <cmath>
#include <complex>
#include <vector>

#include "conductor.hpp"
#include "course/chapter.hpp"
#include "material/fresnel.hpp"
#include "math/degrees.hpp"
#include "schlick.hpp"

namespace sr {

/// Exact, at an angle [degrees] on the side that light comes from.
[[nodiscard]] inline Reflectance<double> glass_at(double theta, double eta) {
    return fresnel(std::cos(radians(theta)), eta);
}

/// Angles [degrees] that are dense where total reflection begins.
[[nodiscard]] inline std::vector<double> angles_from_inside(double last) {
    std::vector<double> angles;
    for (double theta = 0; theta < 37; theta += 3) angles.push_back(theta);
    for (const double theta : {38.0, 39.5, 40.5, 41.0, 41.4, 41.6, 41.75, 41.81, 42.0, 44.0})
        angles.push_back(theta);
    for (double theta = 46; theta <= last; theta += 3) angles.push_back(theta);
    return angles;
}

inline void chart_fresnel(course::Chapter& chapter) {
    auto chart = chapter.chart("fresnel", "Reflectance of glass, $n = 1.5$, and of a metal",
                               {.x = "angle of incidence [deg]", .y = "reflectance"});
    for (int theta = 0; theta <= 87; theta += 3) {
        chart.add("air to glass, $s$", theta, glass_at(theta, 1.5).s);
        chart.add("air to glass, $p$", theta, glass_at(theta, 1.5).p);
        chart.add("air to glass", theta, glass_at(theta, 1.5).mean());
        chart.add("metal, $0.2 + 3i$", theta,
                  fresnel(std::cos(radians(theta)), std::complex{0.2, 3.0}).mean());
    }
    for (const double theta : angles_from_inside(87))
        chart.add("glass to air", theta, glass_at(theta, 1 / 1.5).mean());
    chart.caption(
        "At Brewster's angle, 56.3 degrees, none of the light that is polarised in the plane of incidence, "
        "$p$, is reflected.");
}

inline void chart_schlick(course::Chapter& chapter) {
    auto error = chapter.chart("schlick_error", "Schlick's approximation less the exact reflectance",
                               {.x = "angle of incidence [deg]", .y = "error of the reflectance"});
    for (int theta = 0; theta <= 88; theta += 2) {
        for (const double n : {1.333, 1.5, 2.42})
            error.add(fmt::format("$n = {}$", n), theta,
                      schlick(std::cos(radians(theta)), n) - glass_at(theta, n).mean());
    }
    error.caption("From air. Exact at 0 and at 90 degrees, and worst near 85.");

    auto inside = chapter.chart("schlick_inside", "From glass to air",
                                {.x = "angle of incidence [deg]", .y = "reflectance"});
    for (const double theta : angles_from_inside(60)) {
        const double c = std::cos(radians(theta));
        inside.add("exact", theta, glass_at(theta, 1 / 1.5).mean());
        inside.add("Schlick, cosine inside", theta, textbook_schlick(c, 1 / 1.5));
        inside.add("Schlick, cosine outside", theta, schlick(c, 1 / 1.5));
    }
    inside.caption(
        "With the cosine on the wrong side there is no total reflection, which begins at 41.8 degrees.");
}

}  // namespace sr
