#pragma once
/// @file bounces_chart.hpp
/// Section 8.4: solutions that are known, and the light of so many bounces.

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "course/chapter.hpp"
#include "known_systems.hpp"
#include "lit_room.hpp"
#include "radiosity/direct_solution.hpp"
#include "radiosity/relaxed_jacobi.hpp"

namespace sr {

/// What is missing of the light after so many bounces.
inline void chart_bounces(course::Chapter& chapter) {
    auto       chart = chapter.chart("bounces", "A room of 96 patches: the light of at most $k$ bounces",
                                     {.x = "$k$", .y = "missing share of all light", .log = course::axis::y});
    const auto room  = lit_room(4, 0.5, chapter.options().threads);
    for (const double rho : {0.2, 0.5, 0.8, 0.9}) {
        const auto    grey_room = painted(room, rho);
        const auto    exact     = direct_solution(grey_room);
        RelaxedJacobi jacobi(grey_room);
        double        all = 0;
        for (const auto& radiosity : exact) all += radiosity.r;
        for (int bounces = 0; bounces <= 40; ++bounces) {
            jacobi.step();
            double found = 0;
            for (const auto& radiosity : jacobi.radiosities()) found += radiosity.r;
            const double missing = 1 - found / all;
            if (missing > 1e-9) chart.add(fmt::format("$\\rho = {}$", rho), bounces, missing);
        }
    }
    chart.caption(
        "A straight line with the slope $\\log\\rho$: each bounce has $\\rho$ times the light of the one "
        "before.");
}

/// The first terms of (8.14), by steps of Jacobi.
inline void claim_terms(course::Chapter& chapter) {
    const auto    room = cube_of_faces(std::vector<GreyPatch>(6, {0.5, 1}));
    RelaxedJacobi jacobi(room);
    for (int terms = 1; terms <= 10; ++terms) {
        jacobi.step();
        if (terms != 1 && terms != 5 && terms != 10) continue;
        const double exact = terms == 1 ? 1 : terms == 5 ? 1.9375 : 1.998046875;
        chapter.claim(fmt::format("8.4 closed room, all emit 1 and reflect 0.5: {} terms [W/m^2]", terms),
                      {.expected = exact, .measured = jacobi.radiosities()[0].r, .tolerance = 1e-12});
    }
}

/// Solutions that are known by hand, as the program finds them.
inline void claim_known_systems(course::Chapter& chapter) {
    course::Rows table{{"system", "patch", "radiosity [W/m^2]"}};
    const auto   claim = [&](const std::string& what, const RadiositySystem& system, std::size_t patch,
                           double printed, double digit) {
        const double measured = direct_solution(system)[patch].r;
        table.add({what, int(patch + 1), measured});
        chapter.claim(fmt::format("8.4 {}, patch {} [W/m^2]", what, patch + 1),
                        {.expected = printed, .measured = measured, .tolerance = digit / 2});
    };
    claim("closed room, all emit 1 and reflect 0.9", cube_of_faces(std::vector<GreyPatch>(6, {0.9, 1})), 3,
          10, 1e-9);
    for (const auto& [patch, printed] : {std::pair<std::size_t, double>{0, 1.3158}, {1, 1.0526}})
        claim("plates of 0.3 and 0.8", two_plates({0.3, 1}, {0.8, 0}), patch, printed, 1e-4);
    for (const auto& [patch, printed] : {std::pair<std::size_t, double>{0, 1.0795}, {1, 0.3977}})
        claim("spheres of 0.2 and 0.7", concentric_spheres(2, {0.2, 1}, {0.7, 0}), patch, printed, 1e-4);
    for (const auto& [patch, printed] : {std::pair<std::size_t, double>{0, 1.0319}, {1, 0.1813}})
        claim("strips of 0.6", corner_of_strips({0.6, 1}, {0.6, 0}), patch, printed, 1e-4);
    claim("integrating sphere of 0.98, port of 0.05", inside_of_a_sphere({{0.98, 0.98, 0.95}, {0, 0, 0.05}}),
          0, 14.203, 1e-3);
    const double opening = (1 - std::cos(std::numbers::pi / 6)) / 2;
    claim("cavity of 0.5", inside_of_a_sphere({{0.5, 0.5, 1 - opening}, {0, 0, opening}}), 0, 0.9372, 1e-4);
    const auto   colours = cube_of_faces({{0.1, 0}, {0.2, 0}, {0.3, 0}, {0.4, 0}, {0.5, 0}, {0.6, 1}});
    const double faces[] = {0.02855, 0.05601, 0.08242, 0.10787, 0.13228, 1.04885};
    for (std::size_t face = 0; face < 6; ++face)
        claim("cube of 0.1 to 0.6", colours, face, faces[face], 1e-5);
    chapter.say(table);
}

}  // namespace sr
