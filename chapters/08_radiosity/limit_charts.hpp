#pragma once
/// @file limit_charts.hpp
/// Section 8.9: reflectances of 1 and more, surfaces that see themselves.

#include <cmath>
#include <cstddef>
#include <string>
#include <tuple>
#include <vector>

#include "course/chapter.hpp"
#include "known_systems.hpp"
#include "radiosity/direct_solution.hpp"
#include "radiosity/residual.hpp"

namespace sr {

/// A closed cube whose faces all emit 1.
[[nodiscard]] inline RadiositySystem cube_that_shines(double reflectance) {
    return cube_of_faces(std::vector<GreyPatch>(6, {reflectance, 1}));
}

/// The light after so many bounces.
[[nodiscard]] inline Radiosities after_bounces(const RadiositySystem& system, int bounces) {
    Radiosities B = system.emission;
    for (int k = 0; k < bounces; ++k) {
        const Radiosities before = B;
        for (std::size_t i = 0; i < B.size(); ++i)
            B[i] = system.emission[i] + system.reflectance[i] * irradiance(system.form_factors, before, i);
    }
    return B;
}

inline void chart_above_one(course::Chapter& chapter) {
    auto chart = chapter.chart("above_one", "A closed room that shines, with more and more reflectance",
                               {.x = "reflectance", .y = "radiosity [W/m$^2$]"});
    for (int i = 0; i <= 45; ++i) {
        const double rho = 0.04 * i;
        if (i == 24 || i == 25 || i == 26)
            chart.gap("what solves the equations", rho);
        else
            chart.add("what solves the equations", rho, direct_solution(cube_that_shines(rho))[0].r);
        if (i <= 30) chart.add("light after ten bounces", rho, after_bounces(cube_that_shines(rho), 10)[0].r);
    }
    chart.mark_x(1, "$\\rho = 1$: no solution");
    chart.caption("Beyond 1 there is more light after each bounce, and what solves the equations is none.");
    chapter.claim("8.9 what solves the equations for a reflectance of 1.1, below zero [W/m2]",
                  {10, -direct_solution(cube_that_shines(1.1))[0].r, 1e-9});
    chapter.claim("8.9 light after ten bounces at 1.1 [W/m2]",
                  {18.5, after_bounces(cube_that_shines(1.1), 10)[0].r, 0.05});
}

/// A closed cube of which the last face emits 1. The first one may reflect less than the others.
[[nodiscard]] inline RadiositySystem cube_with_a_lamp(double first, double others) {
    std::vector<GreyPatch> faces(6, {others, 0});
    faces.front().reflectance = first;
    faces.back().emission     = 1;
    return cube_of_faces(faces);
}

/// The mean radiosity of faces of one size.
[[nodiscard]] inline double mean_radiosity(const Radiosities& radiosities) {
    double sum = 0;
    for (const auto& B : radiosities) sum += B.r;
    return sum / double(radiosities.size());
}

/// Bounce by bounce: a closed set that reflects all light, and what very little paint does to it.
inline void chart_closed_set(course::Chapter& chapter) {
    auto chart =
        chapter.chart("closed_set", "A closed cube with a lamp in it",
                      {.x = "bounces added up", .y = "mean radiosity [W/m$^2$]", .log = course::axis::xy});
    const std::string closed = "all reflect 1";
    for (const auto& [name, first, others] : {std::tuple{closed, 1.0, 1.0},
                                              {std::string("one face 0.99, the others 1"), 0.99, 1.0},
                                              {std::string("all 0.99"), 0.99, 0.99},
                                              {std::string("all 0.9"), 0.9, 0.9}}) {
        const auto cube = cube_with_a_lamp(first, others);
        for (const int bounces : {1, 2, 5, 11, 23, 47, 95, 191, 383, 599, 1199, 2399, 5999})
            chart.add(name, bounces, mean_radiosity(after_bounces(cube, bounces)));
    }
    chart.caption("The lamp, one of the six faces, adds 1/6 W/m$^2$ to the mean with each bounce.");
    chapter.claim("8.9 a closed cube of reflectance 1, 599 bounces: mean radiosity [W/m2]",
                  {100, chart.at(closed, 599), 1e-9});
    chapter.claim("8.9 the same after 5999 bounces [W/m2]", {1000, chart.at(closed, 5999), 1e-8});
}

/// The radiosity of a sphere's inside, around one of half its radius that shines. Its F_22 is 3/4.
/// @param sees_itself  or whether that is forgotten
[[nodiscard]] inline double outer_sphere(double reflectance, bool sees_itself) {
    auto system = concentric_spheres(2, {0.2, 1}, {reflectance, 0});
    if (!sees_itself) system.form_factors(1, 1) = 0;
    return direct_solution(system)[1].r;
}

inline void chart_sees_itself(course::Chapter& chapter) {
    auto chart = chapter.chart("sees_itself", "A hollow sphere around one that shines",
                               {.x = "reflectance of the hollow sphere", .y = "its radiosity [W/m$^2$]"});
    for (int i = 0; i <= 38; ++i) {
        chart.add("sees itself, $F_{22} = 3/4$", 0.025 * i, outer_sphere(0.025 * i, true));
        chart.add("$F_{22}$ forgotten", 0.025 * i, outer_sphere(0.025 * i, false));
    }
    chart.caption("Radii 1 and 2; the inner sphere emits 1 and reflects 20 %.");
    chapter.claim("8.9 a hollow sphere of 70 % [W/m2]", {0.39773, outer_sphere(0.7, true), 5e-6});
    chapter.claim("8.9 the same, its light on itself forgotten [W/m2]",
                  {0.1813, outer_sphere(0.7, false), 5e-5});
}

}  // namespace sr
