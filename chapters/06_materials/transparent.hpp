#pragma once
/// @file transparent.hpp
/// Sections 6.8 and 6.9: how much light glass reflects, and how bright it is within.

#include <cmath>
#include <complex>

#include "compressed_light.hpp"
#include "course/claims.hpp"
#include "diagrams.hpp"
#include "fresnel_charts.hpp"
#include "math/extremes.hpp"
#include "math/gauss_legendre.hpp"
#include "photons_chart.hpp"

namespace sr {

/// 6.8  What does glass do?
inline void transparent(course::Chapter& chapter) {
    chapter.section("6.8 Transparent surfaces");
    auto diagram = chapter.diagram("interface", "Air above, glass below");
    draw_interface(diagram);
    diagram.caption("From above, light splits in two; from below, beyond the critical angle, none gets out.");
    chart_fresnel(chapter);
    chart_schlick(chapter);

    const course::Claims claim{chapter, "6.8"};
    const std::complex   gold{0.2, 3.0};
    const double         brewster = degrees(std::atan(1.5));
    claim("Brewster's angle of glass [deg]", 56.3, brewster, 0.05);
    chapter.claim_at_most("6.8 reflectance there, polarised in the plane of incidence",
                          glass_at(brewster, 1.5).p, 1e-20);
    claim("critical angle of glass [deg]", 41.8, degrees(std::asin(1 / 1.5)), 0.05);
    claim("Snell's window of water [deg]", 97.2, 2 * degrees(std::asin(0.75)), 0.05);
    claim("glass at normal incidence", 0.04, glass_at(0, 1.5).mean(), 1e-15);
    claim("glass at 75 degrees", 0.253, glass_at(75, 1.5).mean(), 0.0005);
    claim("from inside at 41 degrees", 0.38, glass_at(41, 1 / 1.5).mean(), 0.005);
    const auto wrong_side = [](double theta) { return textbook_schlick(std::cos(radians(theta)), 1 / 1.5); };
    claim("from inside at 41 degrees, Schlick with the cosine inside", 0.041, wrong_side(41), 0.0005);
    claim("from inside at 60 degrees, Schlick with the cosine inside", 0.07, wrong_side(60), 0.005);
    claim("metal at normal incidence", 0.923, fresnel(1.0, gold).mean(), 0.0005);
    claim("metal at 60 degrees", 0.918, fresnel(0.5, gold).mean(), 0.0005);
    double worst = 0, diffuse = 0;
    for (double theta = 0; theta < 90; theta += 0.01)
        worst =
            max_or_nan(worst, std::abs(schlick(std::cos(radians(theta)), 1.5) - glass_at(theta, 1.5).mean()));
    claim("Schlick's largest error for glass", 0.036, worst, 0.0005);
    for (const auto& [c, weight] : gauss_legendre(64, 0, 1))
        diffuse += weight * 2 * c * fresnel(c, 1.5).mean();
    claim("glass under a uniform sky", 0.092, diffuse, 0.0005);
}

/// 6.9  Why is it brighter in glass than above it?
inline void radiance_in_glass(course::Chapter& chapter) {
    chapter.section("6.9 Radiance in glass");
    const Dielectric<double> glass{1.5};
    const auto               counted = count_photons(glass, 1 << 21, 25, chapter.options().threads);
    chart_photons(chapter, glass, counted);

    const course::Claims claim{chapter, "6.9"};
    const double         refracted = std::asin(std::sin(radians(60)) / 1.5);
    claim("weight of a camera's ray along the normal", 2.16, seen_from_inside(glass, 0), 1e-12);
    claim("weight of one that is seen under 60 degrees outside", 2.049,
          seen_from_inside(glass, degrees(refracted)), 0.0005);
    claim("radiance by photons about the normal", 2.16, counted.L[0], 0.02);
    claim("its standard error", 0.005, counted.se[0], 0.0005);
    claim("share of the photons that gets in", 0.908, counted.passed, 0.001);
    claim("solid angle inside over outside at 60 degrees", 0.272, 0.5 / (2.25 * std::cos(refracted)), 0.0005);
}

}  // namespace sr
