#pragma once
/// @file small_chart.hpp
/// The charts of sections 5.2 and 5.3: small areas by (5.5), and what rounding leaves of small solid angles.

#include <fmt/format.h>

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "course/chapter.hpp"
#include "geometry/disk.hpp"
#include "math/degrees.hpp"
#include "radiometry/disk_solid_angle.hpp"
#include "radiometry/polygon_solid_angle.hpp"
#include "radiometry/solid_angle.hpp"
#include "sampling/cone.hpp"
#include "small_area.hpp"
#include "small_lamps.hpp"
#include "statistics/slope.hpp"

namespace sr {

/// Figure 5.4, and the rule of thumb.
inline void chart_small_areas(course::Chapter& chapter) {
    auto                chart = chapter.chart("small_areas", "How wrong is $A\\, \\cos\\theta' / r^2$?",
                                              {.x = "size / distance (radius of a disk, half the side of a square)",
                                               .y   = "relative error",
                                               .log = course::axis::xy});
    std::vector<double> sizes, errors;
    for (int i = -12; i <= 0; ++i) {
        const double size = std::pow(10.0, i / 6.0);
        chart.add("square", size, small_square_error(size));
        chart.add("disk", size, small_disk_error(size, 0));
        chart.add("disk, turned by 60 degrees", size, small_disk_error(size, radians(60)));
        chart.add("disk, irradiance", size, small_lamp_error(size));
        if (i > -6) continue;
        sizes.push_back(size);
        errors.push_back(small_disk_error(size, 0));
    }
    chart.as_line("square");
    chart.as_points("disk, irradiance");
    chart.caption("Half as large, or twice as far away: a quarter of the error.");
    const auto claim = [&](const std::string& what, double expected, double measured, double tolerance) {
        chapter.claim("5.2 " + what, {.expected = expected, .measured = measured, .tolerance = tolerance});
    };
    claim("slope of the disk's error below a size of 0.1", 2, log_log_slope(sizes, errors).value, 0.01);
    claim("error of a disk five times as far away as it is wide [%]", 0.75, 100 * small_disk_error(0.1, 0),
          0.005);
    claim("error of its irradiance there [%]", 1, 100 * small_lamp_error(0.1), 0.005);
    claim("error of a square five times as far away as it is wide [%]", 1, 100 * small_square_error(0.1),
          0.05);
    claim("error of a disk as far away as its radius [%]", 71, 100 * small_disk_error(1, 0), 0.5);
}

/// Figure 5.5: rounding.
inline void chart_rounding(course::Chapter& chapter) {
    auto              chart  = chapter.chart("rounding", "Small solid angles in float",
                                             {.x = "size / distance (radius of a sphere, legs of a triangle)",
                                              .y = "largest relative error",
                                              .log = course::axis::xy});
    const std::string sphere = "sphere by its cosine (5.6)", triangle = "triangle by its angles";
    const std::string cured_sphere = "sphere (5.7)", cured_triangle = "triangle (5.8)";
    for (int i = -20; i <= -1; ++i) {
        const double size = i == -1 ? 0.7 : std::pow(10.0, i / 4.0);
        chart.add(sphere, size,
                  worst_relative_error(
                      size, [](float r) { return textbook_sphere_solid_angle(r, 1.0F); }, exact_sphere));
        chart.add(triangle, size,
                  worst_relative_error(
                      size, [](float a) { return girard_solid_angle(small_triangle(a)); }, exact_triangle));
        chart.add(cured_sphere, size,
                  worst_relative_error(
                      size, [](float r) { return solid_angle(small_sphere(r)).value(); }, exact_sphere));
        chart.add(cured_triangle, size,
                  worst_relative_error(
                      size, [](float a) { return solid_angle(small_triangle(a)).value(); }, exact_triangle));
    }
    chart.caption("Beyond an error of 1 nothing is left. The worst of 64 sizes that lie close together.");
    const auto of = [&](const std::string& series) { return chart.at(series, 1e-3); };
    chapter.claim("5.3 sphere by its cosine, at a size of 0.001: error [%]",
                  {.expected = 8, .measured = 100 * of(sphere), .tolerance = 0.5});
    chapter.claim("5.3 triangle by its angles, at a size of 0.001: error [%]",
                  {.expected = 58, .measured = 100 * of(triangle), .tolerance = 0.5});
    chapter.claim_at_most("5.3 sphere (5.7), at a size of 0.001: relative error", of(cured_sphere), 3e-7);
    chapter.claim_at_most("5.3 triangle (5.8), at a size of 0.001: relative error", of(cured_triangle), 3e-7);
    chapter.claim(
        "5.3 sphere by its cosine at 10 000 radii, in float [sr]",
        {.expected = 0, .measured = double(textbook_sphere_solid_angle(1.0F, 1e4F)), .tolerance = 0});
    chapter.claim("5.3 sphere by its cosine at 1e8 radii, in double, over the true one",
                  {.expected  = 2.2,
                   .measured  = textbook_sphere_solid_angle(1.0, 1e8) / exact_sphere(1e-8),
                   .tolerance = 0.05});
}

/// What a thing's solid angle is, in numbers that can be checked by hand.
inline void claim_solid_angles(course::Chapter& chapter) {
    using Points     = std::vector<Vector3<double>>;
    const auto claim = [&](const std::string& what, double expected, SolidAngle<double> measured) {
        chapter.claim("5.3 solid angle of " + what + " [sr]",
                      {.expected = expected, .measured = measured.value(), .tolerance = 5e-5});
    };
    const auto   disk = [](double aside) { return Disk<double>{{aside, 0, 1}, {0, 0, 1}, 1}; };
    const Points aside{{1, 0.5, 1}, {3, 0.5, 1}, {3, 2, 1}, {1, 2, 1}};
    const Points dent{{1, 1, 1}, {-1, 1, 1}, {-1, -1, 1}, {1, -1, 1}, {0, 0, 1}};
    claim("a sphere at twice its radius", 0.8418, solid_angle(Sphere<double>{{0, 0, 2}, 1}));
    claim("a disk from its axis", 1.8403, solid_angle(disk(0)));
    claim("a disk from below its rim", 1.1227, solid_angle(disk(1)));
    claim("a square from below its middle", 2.0944, centred_rectangle_solid_angle(1.0, 1.0, 1.0));
    claim("a rectangle aside", 0.2121, solid_angle(aside));
    claim("a triangle", 1.5708, solid_angle(Triangle<double>{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}));
    claim("a square with a dent", 1.5708, solid_angle(dent));
}

/// How many of 200 000 directions to a small lamp are at different distances from its middle.
inline void claim_cone(course::Chapter& chapter) {
    const auto textbook = [](Vec2 u, float s) { return textbook_cone(u, s); };
    const auto cured    = [](Vec2 u, float s) { return sample_cone(u, s); };
    for (const auto& [sine, rings] : {std::pair{1e-2F, 840}, {1e-3F, 10}, {1e-4F, 1}})
        chapter.claim(fmt::format("5.3 rings of a lamp with a sine of {}", sine),
                      {.expected  = double(rings),
                       .measured  = draw_cone(sine, 200'000, textbook).distinct,
                       .tolerance = 0.5});
    chapter.claim_at_most("5.3 of 200 000 by their height, with a sine of 0.001: those alike",
                          200'000 - draw_cone(1e-3F, 200'000, cured).distinct, 4000);
}

}  // namespace sr
