#pragma once
/// @file distance_chart.hpp
/// What section 5.6 measures: two disks, a sphere that recedes, and spheres around a lamp.

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <tuple>
#include <vector>

#include "course/chapter.hpp"
#include "globe.hpp"
#include "math/extremes.hpp"
#include "nested_spheres.hpp"
#include "pinhole_sensor.hpp"
#include "radiometry/solid_angle.hpp"
#include "statistics/slope.hpp"
#include "two_patches.hpp"

namespace sr {

inline void claim_two_disks(course::Chapter& chapter) {
    const TwoDisks disks;
    const auto     area = [](double radius) { return std::numbers::pi * square(radius); };
    course::Rows   table{{"from", "to", "flux [W], counted", "standard error", "irradiance [W/m^2]"}};
    struct Row {
        std::string what;
        double      from, to;
        int         stream;
        Printed     flux, error, irradiance;
    };
    for (const auto& [what, from, to, stream, flux, error, irradiance] :
         {Row{"the large disk to the small one",
              disks.radius_1,
              disks.radius_2,
              1,
              {1.159, 1e-3},
              {0.0031, 1e-4},
              {1.476, 1e-3}},
          Row{"the small disk to the large one",
              disks.radius_2,
              disks.radius_1,
              2,
              {1.157, 1e-3},
              {0.0012, 1e-4},
              {0.3682, 1e-4}}}) {
        const auto counted = estimate(disks.flux(from, to, {chapter.options().threads, 1 << 14, stream}));
        table.add({from, to, counted.value, counted.error, counted.value / area(to)});
        claim_estimate(chapter, "5.6 flux from " + what + ", counted [W]", counted, flux, error);
        chapter.claim("5.6 irradiance from " + what + ", counted [W/m^2]",
                      {.expected  = irradiance.value,
                       .measured  = counted.value / area(to),
                       .tolerance = irradiance.digit / 2});
        chapter.claim_at_most("5.6 from " + what + ", from the closed form, in standard errors",
                              std::abs(counted.value - disks.exact_flux()) / counted.error, 4);
    }
    chapter.say(table);
    chapter.claim("5.6 flux between two disks, closed form [W]",
                  {.expected = 1.1569, .measured = disks.exact_flux(), .tolerance = 5e-5});
    chapter.claim(
        "5.6 irradiance of the small disk, closed form [W/m^2]",
        {.expected = 1.473, .measured = disks.exact_flux() / area(disks.radius_2), .tolerance = 5e-4});
    chapter.claim(
        "5.6 irradiance of the large disk, closed form [W/m^2]",
        {.expected = 0.3683, .measured = disks.exact_flux() / area(disks.radius_1), .tolerance = 5e-5});
}

/// The pictures of figure 5.12.
inline void render_globes(course::Chapter& chapter) {
    const int size = chapter.options().size, threads = chapter.options().threads;
    for (const int distance : {5, 10, 20})
        chapter.render(fmt::format("globe_{}", distance), fmt::format("A globe {} radii away", distance),
                       "It gets smaller, and not darker.", render_globe(distance, size, threads));
}

/// Figure 5.14: what is counted behind a pinhole.
inline void chart_receding_sphere(course::Chapter& chapter) {
    auto                chart = chapter.chart("receding", "A sphere of radiance 1 recedes",
                                              course::with_error({.x = "distance [radii]",
                                                                  .y = "relative to the closed form at a distance of 5",
                                                                  .log = course::axis::xy}));
    const PinholeSensor sensor;
    course::Rows        table{{"distance [radii]", "radiance", "standard error", "irradiance [W/m^2]",
                               "standard error", "pi / d^2"}};
    struct Row {
        int     distance;
        Printed radiance, radiance_error, irradiance, irradiance_error;
    };
    double              farthest = 0;
    std::vector<double> distances, irradiances;
    const double        pi = std::numbers::pi;
    for (const auto& [distance, radiance, radiance_error, irradiance, irradiance_error] :
         {Row{5, {0.9936, 1e-4}, {0.0057, 1e-4}, {0.1253, 1e-4}, {0.0002, 1e-4}},
          Row{10, {0.9989, 1e-4}, {0.0047, 1e-4}, {0.0314, 1e-4}, {0.00005, 1e-5}},
          Row{20, {1.0056, 1e-4}, {0.0044, 1e-4}, {0.00786, 1e-5}, {0.00001, 1e-5}},
          Row{50, {0.9995, 1e-4}, {0.0045, 1e-4}, {0.001258, 1e-6}, {0.0000015, 1e-7}}}) {
        const auto L = estimate(sensor.radiance(distance, {chapter.options().threads, 1 << 13, distance}));
        const auto E = estimate(sensor.irradiance(distance, {chapter.options().threads, 1 << 12, distance}));
        const double exact = pi / square(double(distance)), near = pi / 25;
        chart.add("radiance in a pixel, counted", distance, L);
        chart.add("irradiance, counted", distance, Estimate{E.value / near, E.error / near});
        chart.add("$\\pi / d^2$", distance, Estimate{exact / near});
        table.add({distance, L.value, L.error, E.value, E.error, exact});
        claim_estimate(chapter, fmt::format("5.6 radiance from {} radii, counted [W/(m^2 sr)]", distance), L,
                       radiance, radiance_error);
        claim_estimate(chapter, fmt::format("5.6 irradiance from {} radii, counted [W/m^2]", distance), E,
                       irradiance, irradiance_error);
        farthest = max_or_nan(
            farthest, max_or_nan(std::abs(L.value - 1) / L.error, std::abs(E.value - exact) / E.error));
        distances.push_back(distance);
        irradiances.push_back(E.value);
    }
    chart.as_line("$\\pi / d^2$");
    chart.as_points("radiance in a pixel, counted");
    chart.as_points("irradiance, counted");
    chart.caption(
        "Light from all of the sphere, counted where it comes through a pinhole and where it meets a pixel.");
    chapter.say(table);
    chapter.claim_at_most("5.6 from a radiance of 1 and from pi / d^2, in standard errors", farthest, 4);
    chapter.claim(
        "5.6 the power of the distance with which irradiance falls",
        {.expected = 2, .measured = -log_log_slope(distances, irradiances).value, .tolerance = 0.005});
}

/// Seen from afar, irradiance over solid angle is the radiance again.
inline void claim_far_spheres(course::Chapter& chapter) {
    for (const auto& [d, expected, digit] : {std::tuple{5.0, 0.9899, 1e-4}, {50.0, 0.9999, 1e-4}}) {
        const Sphere<double> sphere{{0, 0, d}, 1};
        chapter.claim(fmt::format("5.6 irradiance over solid angle at {} radii [W/(m^2 sr)]", d),
                      {.expected  = expected,
                       .measured  = projected_solid_angle(sphere) / solid_angle(sphere),
                       .tolerance = digit / 2});
    }
}

/// Figure 5.15: no flux is lost between spheres.
inline void chart_nested_spheres(course::Chapter& chapter) {
    auto chart =
        chapter.chart("nested_spheres", "Spheres around a lamp",
                      {.x = "radius [m]", .y = "relative to a radius of 1 m", .log = course::axis::xy});
    const double whole = flux_through_sphere(1), unit = 4 * std::numbers::pi;
    course::Rows table{{"radius [m]", "mean irradiance [W/m^2]", "flux [W]"}};
    for (const auto& [radius, mean, digit] :
         {std::tuple{1.0, 0.7854, 1e-4}, {2.0, 0.19635, 1e-5}, {5.0, 0.03142, 1e-5}, {10.0, 0.00785, 1e-5}}) {
        const double flux = flux_through_sphere(radius), area = unit * square(radius);
        table.add({radius, flux / area, flux});
        chart.add("flux", radius, flux / whole);
        chart.add("mean irradiance", radius, flux / area / (whole / unit));
        chapter.claim(
            fmt::format("5.6 mean irradiance of a sphere of radius {} around the lamp [W/m^2]", radius),
            {.expected = mean, .measured = flux / area, .tolerance = digit / 2});
        chapter.claim(fmt::format("5.6 flux through it, radius {} [W]", radius),
                      {.expected = 9.8696, .measured = flux, .tolerance = 5e-5});
    }
    chart.caption("The lamp is not in the middle. On each sphere arrives all that it emits.");
    chapter.say(table);
}

}  // namespace sr
