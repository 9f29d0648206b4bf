#pragma once
/// @file grazing_chart.hpp

#include <numbers>

#include "course/chapter.hpp"
#include "cures.hpp"
#include "material/phong_albedo.hpp"
#include "reflected.hpp"

namespace sr {

/// Albedo against the angle, of two scales and two divisions.
[[nodiscard]] inline course::Chart chart_grazing(course::Chapter& chapter, const HemisphereRule& rule) {
    constexpr double      two_pi = 2 * std::numbers::pi;
    const DividedByCosine over_cosine{Phong{10.0, PhongScale::density}};
    const DividedByLarger over_larger{Phong{10.0}};

    auto chart = chapter.chart("grazing", "Albedo of Phong's lobe against the angle",
                               {.x = "angle of incidence [deg]", .y = "albedo"});
    for (int step = 0; step <= 30; ++step) {
        const double theta = step < 30 ? 3 * step : 89.9;
        const auto   wo    = at_angle(theta);
        const double a     = phong_albedo(10, radians(theta));
        chart.add("$(e+1)/2\\pi$", theta, 11 / two_pi * a);
        chart.add("$(e+2)/2\\pi$", theta, 12 / two_pi * a);
        chart.add("over $\\cos\\theta_i$", theta, albedo(over_cosine, wo, rule));
        chart.add("over the larger cosine", theta, albedo(over_larger, wo, rule));
        chart.add("diffuse, mirror", theta, 1);
        chart.add("$(e+2)/2\\pi$, $e = 10^4$", theta, 10002 / two_pi * phong_albedo(1e4, radians(theta)));
    }
    chart.as_line("diffuse, mirror");
    chart.caption(
        "Exponent 10, but for one curve. Diffuse and mirror are 1 throughout; the narrow lobe is a cosine.");
    return chart;
}

}  // namespace sr
