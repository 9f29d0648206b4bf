#pragma once
/// @file limit_charts.hpp
/// Section 8.9: reflectances of 1 and more, surfaces that see themselves, faces without an area.

#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <vector>

#include "course/chapter.hpp"
#include "known_systems.hpp"
#include "math/extremes.hpp"
#include "math/gauss_legendre.hpp"
#include "radiosity/direct_solution.hpp"
#include "radiosity/point_form_factors.hpp"
#include "radiosity/residual.hpp"

namespace sr {

/// A closed cube whose faces all emit 1.
[[nodiscard]] inline RadiositySystem cube_that_shines(double reflectance) {
    return cube_of_faces(std::vector<GreyPatch>(6, {reflectance, 1}));
}

/// Its light after so many bounces.
[[nodiscard]] inline double after_bounces(double reflectance, int bounces) {
    const auto  system = cube_that_shines(reflectance);
    Radiosities B      = system.emission;
    for (int k = 0; k < bounces; ++k) {
        const Radiosities before = B;
        for (std::size_t i = 0; i < B.size(); ++i)
            B[i] = system.emission[i] + system.reflectance[i] * irradiance(system.form_factors, before, i);
    }
    return B[0].r;
}

inline void chart_above_one(course::Chapter& chapter) {
    auto chart = chapter.chart("above_one", "A closed room that shines, with more and more reflectance",
                               {.x = "reflectance", .y = "radiosity [W/m$^2$]"});
    for (int i = 0; i <= 36; ++i) {
        const double rho = 0.05 * i;
        if (i == 19 || i == 20 || i == 21)
            chart.gap("what solves the equations", rho);
        else
            chart.add("what solves the equations", rho, direct_solution(cube_that_shines(rho))[0].r);
        if (rho < 1.25) chart.add("light after ten bounces", rho, after_bounces(rho, 10));
    }
    chart.mark_x(1, "no solution");
    chart.caption("Beyond 1 there is more light after each bounce, and what solves the equations is none.");
    chapter.claim("8.9 what solves the equations for a reflectance of 1.1, below zero [W/m2]",
                  {10, -direct_solution(cube_that_shines(1.1))[0].r, 1e-9});
    chapter.claim("8.9 light after ten bounces at 1.1 [W/m2]", {18.5, after_bounces(1.1, 10), 0.05});
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

/// A rectangle that leans, 1 long, in the middle below a unit square that faces it at the distance 1.
struct Sliver {
    Vector3<double> n{2.0 / 3, -1.0 / 3, 2.0 / 3}, d = normalize(Vector3<double>{1, 2, 0}), e = cross(n, d);
    Vector3<double> middle{100.3, 50.7, 20.1};  ///< where coordinates are as in a file: not near 0

    [[nodiscard]] Patch rectangle(double width, double height) const {
        const auto at = [&](double s, double t) { return middle + height * n + s * d + width * t * e; };
        return {at(-0.5, -0.5), at(0.5, -0.5), at(0.5, 0.5), at(-0.5, 0.5)};
    }

    /// By how much the form factor to the square is wrong, as a share of itself.
    /// @throws std::invalid_argument where the area is 0
    [[nodiscard]] double error(double width) const {
        const Patch roof = rectangle(1, 1).reversed(), sliver = rectangle(width, 0);
        double      F = 0, exact = 0;  // along the middle line
        for (const auto& [s, weight] : gauss_legendre(8, 0, 1)) {
            F += weight * contour_form_factor(sliver.at({s, 0.5}), sliver.normal(), roof);
            exact += weight * contour_form_factor(middle + (s - 0.5) * d, n, roof);
        }
        return std::abs(F / exact - 1);
    }
};

/// The largest error of slivers in 16 places; NaN if one of them has no area.
[[nodiscard]] inline double sliver_error(double width) try {
    double largest = 0;
    for (int k = 0; k < 16; ++k) {
        Sliver sliver;
        sliver.middle += 0.37 * k * sliver.d;
        largest = max_or_nan(largest, sliver.error(width));
    }
    return largest;
} catch (const std::invalid_argument&) {
    return NAN;
}

inline void chart_slivers(course::Chapter& chapter) {
    auto chart = chapter.chart("slivers", "From a sliver to a square",
                               {.x = "width of the sliver", .y = "error", .log = course::axis::xy});
    for (int i = -32; i <= -6; ++i) {
        const double width = std::pow(10.0, i / 2.0), error = sliver_error(width);
        if (error > 0) {
            chart.add("of its form factor, relative", width, error);
            chart.add("of the light that it sends", width, width * error);
        } else {
            chart.gap("of its form factor, relative", width);
            chart.gap("of the light that it sends", width);
        }
    }
    chart.caption("The worst of 16, about 100 from the origin. Narrower ones have rounded to a line: 0 / 0.");
}

}  // namespace sr
