#pragma once
/// @file relaxation_charts.hpp
/// Section 8.5: what lambda does to relaxed Jacobi.

#include <fmt/format.h>

#include <cmath>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "course/chapter.hpp"
#include "known_systems.hpp"
#include "radiosity/relaxation.hpp"
#include "radiosity/relaxed_jacobi.hpp"
#include "steps_to_a_millionth.hpp"
#include "textbook_jacobi.hpp"

namespace sr {

/// The cube of one colour, a patch for a face, of which one shines.
[[nodiscard]] inline RadiositySystem cube_of_one_colour(double reflectance) {
    std::vector<GreyPatch> faces(6, {reflectance, 0});
    faces.back().emission = 1;
    return cube_of_faces(faces);
}

/// Steps against lambda, measured, beside what the largest |1 - lambda mu| says.
inline void chart_lambda(course::Chapter& chapter) {
    auto chart            = chapter.chart("lambda", "A cube of six faces: steps to a millionth of the error",
                                          {.x = "$\\lambda$", .y = "steps", .log = course::axis::y});
    const std::string law = "by (8.17)";
    using course::Ink;
    for (const auto& [rho, printed, ink] :
         {std::tuple{0.5, 1.818, Ink::vermilion}, {0.9, 1.695, Ink::green}, {0.99, 1.669, Ink::purple}}) {
        const auto        system  = cube_of_one_colour(rho);
        const auto        mu      = jacobi_eigenvalues(system);
        const double      bound   = largest_stable_lambda(mu);
        const std::string counted = fmt::format("$\\rho = {}$", rho);
        for (int i = 20; i <= 198; ++i) {
            const double lambda = i / 200.0 * bound;
            chart.add(law, lambda, std::log(1e-6) / std::log(spectral_radius(mu, lambda)));
            if (i % 10 == 0)
                chart.add(counted, lambda, steps_to_a_millionth(system, RelaxedJacobi(system, lambda)));
        }
        chart.gap(law, bound);
        chart.as_points(counted);
        chart.in_ink(counted, ink);
        chart.mark_x(bound, fmt::format("{:.3f}", bound), ink);
        chapter.claim(fmt::format("8.5 cube, reflectance {}: the largest stable lambda", rho),
                      {.expected = printed, .measured = bound, .tolerance = 5e-4});
    }
    chart.as_line(law);
    chart.caption("Beyond the vertical lines the steps grow without end. The fewest are near them, above 1.");
}

/// Lines of equal spectral radius over reflectance and lambda.
inline void chart_lambda_map(course::Chapter& chapter) {
    auto chart = chapter.chart("lambda_map", "A cube of six faces: by what a step multiplies the error",
                               {.x = "reflectance", .y = "$\\lambda$"});
    const std::string border = "1: diverges above", best = "the best $\\lambda$";
    for (int i = 0; i <= 99; ++i) {
        const double rho = i / 100.0;
        const auto   mu  = jacobi_eigenvalues(cube_of_one_colour(rho));
        chart.add(border, rho, largest_stable_lambda(mu));
        chart.add(best, rho, best_lambda(mu));
    }
    chart.as_line(border);
    chart.as_line(best);
    chart.in_ink(border, course::Ink::black);
    for (const double radius : {0.8, 0.6, 0.4, 0.2}) {
        const std::string                      name = fmt::format("{}", radius);
        // The error's slowest part gives the lower side of a line, its fastest the upper one: they meet at the best.
        std::vector<std::pair<double, double>> upper;
        for (int i = 0; i <= 990; ++i) {
            const double rho   = i / 1000.0;
            const auto   mu    = jacobi_eigenvalues(cube_of_one_colour(rho));
            double       least = 2, most = 0;
            for (const auto& m : mu) {
                least = std::min(least, m.real());
                most  = std::max(most, m.real());
            }
            if ((1 - radius) / least > (1 + radius) / most) break;
            chart.add(name, rho, (1 - radius) / least);
            upper.emplace_back(rho, (1 + radius) / most);
        }
        for (std::size_t i = upper.size(); i-- > 0;) chart.add(name, upper[i].first, upper[i].second);
        chart.as_line(name);
        chart.in_ink(name, course::Ink::blue);
    }
    chart.caption("Blue: lines of equal spectral radius. Above that of 1 nothing converges.");
}

/// The cube at its best lambda, and a sphere in pieces that see themselves.
inline void claim_bounds(course::Chapter& chapter) {
    for (const auto& [rho, best, radius] :
         {std::tuple{0.5, 1.2499, 0.3751}, {0.9, 1.5622, 0.8438}, {0.99, 1.6553, 0.9834}}) {
        const auto mu = jacobi_eigenvalues(cube_of_one_colour(rho));
        chapter.claim(fmt::format("8.5 cube, reflectance {}: best lambda", rho),
                      {.expected = best, .measured = best_lambda(mu), .tolerance = 5e-5});
        chapter.claim(
            fmt::format("8.5 cube, reflectance {}: spectral radius at the best lambda", rho),
            {.expected = radius, .measured = spectral_radius(mu, best_lambda(mu)), .tolerance = 5e-5});
    }
    for (const auto& [pieces, bound] : {std::pair<std::size_t, double>{1, 2.0}, {2, 1.1}, {8, 1.775}}) {
        const auto sphere = inside_of_a_sphere(std::vector<GreyPatch>(pieces, {0.9, 1}));
        chapter.claim(
            fmt::format("8.5 sphere in {} pieces, reflectance 0.9: the largest stable lambda", pieces),
            {.expected  = bound,
             .measured  = largest_stable_lambda(jacobi_eigenvalues(sphere)),
             .tolerance = 1e-9});
    }
}

/// Two facing plates, for which all is known by hand.
inline void claim_two_plates(course::Chapter& chapter) {
    for (const auto& [rho, lambda, radius, steps] : {std::tuple{0.5, 0.5, 0.75, 49},
                                                     {0.5, 1.0, 0.5, 20},
                                                     {0.9, 0.5, 0.95, 270},
                                                     {0.9, 1.0, 0.9, 132},
                                                     {0.9, 1.05, 0.995, 125},
                                                     {0.99, 1.0, 0.99, 1375},
                                                     {0.99, 1.05, 1.0895, 1309}}) {
        const auto system = two_plates({rho, 1}, {rho, 1});
        chapter.claim(fmt::format("8.5 two plates, reflectance {}, lambda {}: spectral radius", rho, lambda),
                      {.expected  = radius,
                       .measured  = spectral_radius(jacobi_eigenvalues(system), lambda),
                       .tolerance = 1e-9});
        chapter.claim(
            fmt::format("8.5 two plates, reflectance {}, lambda {}: steps to a millionth", rho, lambda),
            {.expected  = double(steps),
             .measured  = double(steps_to_a_millionth(system, TextbookJacobi(system, lambda))),
             .tolerance = 0.5});
    }
}

/// What 200 steps make of two plates, of which the first emits 1.
inline void claim_too_large_lambda(course::Chapter& chapter) {
    const auto   plates = two_plates({0.9, 1}, {0.9, 0});
    course::Rows table{{"lambda", "first plate [W/m^2]", "second plate [W/m^2]"}};
    for (const auto& [lambda, first, second, digit] : {std::tuple{1.0, 5.263, 4.737, 0.001},
                                                       {1.05, 5.167, 4.833, 0.001},
                                                       {1.06, 1.019, 8.981, 0.001},
                                                       {1.1, 8045000.0, 8045000.0, 1000.0}}) {
        TextbookJacobi jacobi(plates, lambda);
        for (int step = 0; step < 200; ++step) jacobi.step();
        const auto& found = jacobi.radiosities();
        table.add({lambda, found[0].r, found[1].r});
        chapter.claim(
            fmt::format("8.5 plates, lambda {}: magnitude of the first after 200 steps [W/m^2]", lambda),
            {.expected = first, .measured = std::abs(found[0].r), .tolerance = digit / 2});
        chapter.claim(fmt::format("8.5 plates, lambda {}: the second after 200 steps [W/m^2]", lambda),
                      {.expected = second, .measured = found[1].r, .tolerance = digit / 2});
    }
    chapter.say(table);
}

}  // namespace sr
