#pragma once
/// @file distance_chart.hpp
/// What section 5.6 measures: two disks, and a sphere that recedes.

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "course/chapter.hpp"
#include "nested_spheres.hpp"
#include "receding_sphere.hpp"
#include "statistics/slope.hpp"
#include "two_patches.hpp"

namespace sr {

inline void claim_two_disks(course::Chapter& chapter) {
    const TwoDisks disks;
    const int      threads = chapter.options().threads;
    const auto     there   = disks.flux(disks.radius_1, disks.radius_2, {threads, 1 << 14, 1});
    const auto     back    = disks.flux(disks.radius_2, disks.radius_1, {threads, 1 << 14, 2});
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
    course::Rows         table{{"distance [radii]", "brightest pixel", "irradiance [W/m^2]", "pi / d^2"}};
    for (const double distance : {5.0, 10.0, 20.0, 40.0}) {
        const auto seen = sphere.look(distance, threads);
        chart.add("brightest pixel", distance, seen.brightest / near.brightest);
        chart.add("irradiance, summed over the pixels", distance, seen.irradiance / near.irradiance);
        table.add({distance, seen.brightest, seen.irradiance, std::numbers::pi / square(distance)});
        distances.push_back(distance);
        irradiances.push_back(seen.irradiance);
    }
    chart.caption("Both measured in the same images of 256 x 256 pixels.");
    chapter.say(table);
    const auto claim = [&](const std::string& what, double expected, double measured, double tolerance) {
        chapter.claim("5.6 " + what, {.expected = expected, .measured = measured, .tolerance = tolerance});
    };
    for (const double distance : distances)
        claim(fmt::format("brightest pixel at {} radii", distance), 1,
              near.brightest * chart.at("brightest pixel", distance), 0);
    for (const auto& [i, expected, digit] :
         {std::tuple{0U, 0.1257, 1e-4}, {1U, 0.0314, 1e-4}, {2U, 0.00785, 1e-5}, {3U, 0.00196, 1e-5}})
        claim(fmt::format("irradiance at {} radii, of the pixels [W/m^2]", distances[i]), expected,
              irradiances[i], digit / 2);
    claim("the power of the distance with which irradiance falls", 2,
          -log_log_slope(distances, irradiances).value, 0.005);
}

/// Seen from afar, irradiance over solid angle is the radiance again; and no flux is lost between spheres.
inline void claim_nested_spheres(course::Chapter& chapter) {
    for (const auto& [d, expected, digit] : {std::tuple{5.0, 0.9899, 1e-4}, {50.0, 0.9999, 1e-4}}) {
        const Sphere<double> sphere{{0, 0, d}, 1};
        chapter.claim(fmt::format("5.6 irradiance over solid angle at {} radii [W/(m^2 sr)]", d),
                      {.expected  = expected,
                       .measured  = projected_solid_angle(sphere) / solid_angle(sphere),
                       .tolerance = digit / 2});
    }
    course::Rows table{{"radius", "mean irradiance [W/m^2]", "flux [W]"}};
    for (const auto& [radius, mean] :
         {std::pair{1.0, 0.7854}, {2.0, 0.19635}, {4.0, 0.04909}, {8.0, 0.01227}}) {
        const double flux = flux_through_sphere(radius), area = 4 * std::numbers::pi * square(radius);
        table.add({radius, flux / area, flux});
        chapter.claim(
            fmt::format("5.6 mean irradiance of a sphere of radius {} around the lamp [W/m^2]", radius),
            {.expected = mean, .measured = flux / area, .tolerance = radius > 1 ? 5e-6 : 5e-5});
        chapter.claim(fmt::format("5.6 flux through it, radius {} [W]", radius),
                      {.expected = 9.8696, .measured = flux, .tolerance = 5e-5});
    }
    chapter.say(table);
}

}  // namespace sr
