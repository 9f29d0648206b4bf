#pragma once
/// @file distance_chart.hpp
/// What section 5.6 measures: two disks, and a sphere that recedes.

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "course/chapter.hpp"
#include "receding_sphere.hpp"
#include "statistics/slope.hpp"
#include "two_patches.hpp"

namespace sr {

inline void claim_two_disks(course::Chapter& chapter) {
    const TwoDisks disks;
    const int      threads = chapter.options().threads;
    const auto     there   = disks.flux(disks.radius_1, disks.radius_2, threads, 1 << 14);
    const auto     back    = disks.flux(disks.radius_2, disks.radius_1, threads, 1 << 14);
    chapter.claim("5.6 flux between two disks, closed form [W]",
                  {.expected = 1.1569, .measured = disks.exact_flux(), .tolerance = 5e-5});
    chapter.claim("5.6 flux from the large disk to the small one, by rays [W]",
                  {.expected = 1.16, .measured = there.mean(), .tolerance = 0.015});
    chapter.claim("5.6 flux from the small disk to the large one, by rays [W]",
                  {.expected = 1.158, .measured = back.mean(), .tolerance = 0.005});
    const double small = std::numbers::pi * square(disks.radius_2);
    chapter.claim("5.6 irradiance of the small disk [W/m^2]",
                  {.expected = 1.473, .measured = disks.exact_flux() / small, .tolerance = 5e-4});
    chapter.claim("5.6 irradiance of the large disk [W/m^2]",
                  {.expected = 0.368, .measured = disks.exact_flux() / (4 * small), .tolerance = 5e-4});
}

/// Figures 5.12 and 5.14.
inline void chart_receding_sphere(course::Chapter& chapter) {
    const int size = chapter.options().size, threads = chapter.options().threads;
    for (const int distance : {5, 10, 20})
        chapter.render(fmt::format("globe_{}", distance), fmt::format("A globe {} radii away", distance),
                       "It gets smaller, and not darker.", render_globe(distance, size, threads));

    auto chart =
        chapter.chart("receding", "A sphere of radiance 1 recedes",
                      {.x = "distance [radii]", .y = "relative to a distance of 5", .log = course::axis::xy});
    const RecedingSphere sphere(256);  // whatever the picture's size: the numbers are in the text
    const auto           near = sphere.look(5, threads);
    std::vector<double>  distances, irradiances;
    for (const double distance : {5.0, 10.0, 20.0, 40.0}) {
        const auto seen = sphere.look(distance, threads);
        chart.add("brightest pixel", distance, seen.brightest / near.brightest);
        chart.add("irradiance, summed over the pixels", distance, seen.irradiance / near.irradiance);
        distances.push_back(distance);
        irradiances.push_back(seen.irradiance);
    }
    chart.caption("Both measured in the same images of 256 x 256 pixels.");
    const auto far = sphere.look(40, threads);
    chapter.claim("5.6 brightest pixel at 5 radii",
                  {.expected = 1, .measured = near.brightest, .tolerance = 0});
    chapter.claim("5.6 brightest pixel at 40 radii",
                  {.expected = 1, .measured = far.brightest, .tolerance = 0});
    chapter.claim("5.6 irradiance at 5 radii, of the pixels [W/m^2]",
                  {.expected = 0.1257, .measured = near.irradiance, .tolerance = 5e-5});
    chapter.claim("5.6 irradiance at 40 radii, of the pixels [W/m^2]",
                  {.expected = 0.00196, .measured = far.irradiance, .tolerance = 5e-6});
    chapter.claim(
        "5.6 the power of the distance with which irradiance falls",
        {.expected = 2, .measured = -log_log_slope(distances, irradiances).value, .tolerance = 0.005});
}

}  // namespace sr
