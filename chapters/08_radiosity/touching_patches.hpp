#pragma once
/// @file touching_patches.hpp
/// Section 8.3: patches that touch, or nearly, and what the textbook's forms make of them.

#include <fmt/format.h>

#include <cmath>
#include <tuple>

#include "course/chapter.hpp"
#include "factor_methods.hpp"

namespace sr {

/// Relative error of the form factor of two squares at a right angle, both cut into n x n.
struct TouchingError {
    double points, disks, contours;
};

[[nodiscard]] inline TouchingError touching_error(int n) {
    const Patch  from = level_square(), to = upright_square();
    const double exact = perpendicular_rectangles(1, 1, 1);
    return {summed_over_pieces(from, to, n, point_form_factor) / exact - 1,
            summed_over_pieces(from, to, n, disk_form_factor) / exact - 1,
            summed_contours(from, to, n) / exact - 1};
}

inline void chart_touching(course::Chapter& chapter) {
    auto chart = chapter.chart("touching", "Two unit squares that share an edge",
                               {.x   = "pieces along a side of each square",
                                .y   = "relative error of the form factor, absolute value",
                                .log = course::axis::xy});
    for (int n = 1; n <= 32; n *= 2) {
        const auto error = touching_error(n);
        chart.add("points", n, std::abs(error.points));
        chart.add("disks", n, std::abs(error.disks));
        chart.add("contour", n, std::abs(error.contours));
    }
    for (const char* method : {"points", "disks", "contour"}) chart.in_ink(method, ink_of_method(method));
    chart.caption("Points and disks sum up pairs of pieces; the contour knows the other square as a whole.");
    chapter.claim("8.3 touching squares in 32 x 32 pieces, contour: error",
                  {.expected = 4e-5, .measured = chart.at("contour", 32), .tolerance = 0.5e-5});
    for (const auto& [n, points, disks] : {std::tuple{1, 59.1, 2.8},
                                           {2, 32.0, 4.4},
                                           {4, 16.5, 3.6},
                                           {8, 8.3, 2.3},
                                           {16, 4.2, 1.3},
                                           {32, 2.1, 0.7}}) {
        const auto error = touching_error(n);
        const auto what  = fmt::format("touching squares in {} x {} pieces", n, n);
        chapter.claim(fmt::format("8.3 {}, points: too large by [%]", what),
                      {.expected = points, .measured = 100 * error.points, .tolerance = 0.05});
        chapter.claim(fmt::format("8.3 {}, disks: too small by [%]", what),
                      {.expected = disks, .measured = -100 * error.disks, .tolerance = 0.05});
    }
}

/// Two opposed squares that come near.
inline void chart_near(course::Chapter& chapter) {
    auto chart = chapter.chart("near_patches", "Two opposed unit squares, from middle to middle",
                               {.x = "distance [sides]", .y = "form factor", .log = course::axis::xy});
    for (int i = -20; i <= 10; ++i) {
        const double distance = std::pow(10.0, i / 10.0);
        const Patch  from = level_square(), to = level_square(distance).reversed();
        chart.add("points", distance, point_form_factor(from, to));
        chart.add("disks", distance, disk_form_factor(from, to));
        chart.add("exact", distance, opposed_rectangles(1, 1, distance));
    }
    for (const char* method : {"points", "disks"}) chart.in_ink(method, ink_of_method(method));
    chart.as_line("exact");
    chart.in_ink("exact", course::Ink::black);
    chart.caption("No patch can send more than all of its light: a form factor above 1 is wrong.");
    for (const auto& [distance, points, exact] : {std::tuple{1.0, 0.3183, 0.1998},
                                                  {0.5, 1.273, 0.4153},
                                                  {0.1, 31.83, 0.8270},
                                                  {0.01, 3183.0, 0.9804}}) {
        const Patch from = level_square(), to = level_square(distance).reversed();
        chapter.claim(
            fmt::format("8.3 opposed squares at {}, points", distance),
            {.expected = points, .measured = point_form_factor(from, to), .tolerance = points * 2e-4});
        chapter.claim(fmt::format("8.3 opposed squares at {}, exact", distance),
                      {.expected = exact, .measured = opposed_rectangles(1, 1, distance), .tolerance = 5e-5});
    }
}

}  // namespace sr
