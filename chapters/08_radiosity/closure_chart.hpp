#pragma once
/// @file closure_chart.hpp
/// Section 8.4: what rows that don't add up to 1 do, and what is done about them.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "course/chapter.hpp"
#include "factor_methods.hpp"
#include "inside_of_a_cube.hpp"
#include "known_systems.hpp"
#include "radiosity/closure.hpp"
#include "radiosity/direct_solution.hpp"
#include "radiosity/reciprocity.hpp"

namespace sr {

/// A cube's six faces, whose form factors are known, each times 1 + e.
[[nodiscard]] inline FormFactorMatrix cube_with_defect(double e) {
    const double     opposed = opposed_rectangles(1, 1, 1), beside = perpendicular_rectangles(1, 1, 1);
    FormFactorMatrix F(6);
    for (std::size_t i = 0; i < 6; ++i)
        for (std::size_t j = 0; j < 6; ++j)
            if (i != j) F(i, j) = (1 + e) * (i / 2 == j / 2 ? opposed : beside);
    return F;
}

/// B of faces that all emit 1 and reflect rho. It should be 1 / (1 - rho).
[[nodiscard]] inline double radiosity_in_cube(const FormFactorMatrix& F, double rho) {
    const std::vector<GreyPatch> faces(6, {rho, 1});
    const auto system = grey_system(faces, [&](std::size_t i, std::size_t j) { return F(i, j); });
    return direct_solution(system)[0].r;
}

/// The error of B against 1 - rho.
inline void chart_closure(course::Chapter& chapter) {
    auto chart = chapter.chart("closure", "Six faces of a cube, all alike: rows off by 0.5 %",
                               {.x   = "$1 - \\rho$",
                                .y   = "relative error of the radiosity, absolute value",
                                .log = course::axis::xy});
    for (int i = 0; i <= 30; ++i) {
        const double rho   = 1 - std::pow(10.0, -i / 10.0 - 0.05);
        const auto   error = [&](const FormFactorMatrix& F) {
            return std::abs(radiosity_in_cube(F, rho) * (1 - rho) - 1);
        };
        chart.add("rows add up to 1.005", 1 - rho, error(cube_with_defect(0.005)));
        chart.add("rows add up to 0.995", 1 - rho, error(cube_with_defect(-0.005)));
        chart.add("scaled to 1", 1 - rho,
                  std::max(1e-16, error(symmetrically_scaled(cube_with_defect(0.005)))));
    }
    chart.caption(
        "1: no digit is right. Left of the peak $1.005\\,\\rho > 1$, and the radiosity is negative.");
    for (const auto& [rho, e, B] : {std::tuple{0.5, -0.005, 1.99},
                                    {0.5, 0.005, 2.0101},
                                    {0.9, -0.005, 9.5694},
                                    {0.9, 0.005, 10.471},
                                    {0.99, -0.005, 66.89},
                                    {0.99, 0.005, 198.02}})
        chapter.claim(
            fmt::format("8.4 B with a reflectance of {} and rows that add up to {}", rho, 1 + e),
            {.expected = B, .measured = radiosity_in_cube(cube_with_defect(e), rho), .tolerance = B * 6e-5});
}

/// A cube's faces in 3 x 3 patches, whose form factors are estimated by four random pairs each.
[[nodiscard]] inline FormFactorMatrix rough_factors_of_cube() {
    const Patches    patches = cut(inside_of_a_cube(), 1.0 / 3);
    const Visibility open{mesh_of(patches).mesh};
    FormFactorMatrix F(patches.size());
    for (std::size_t i = 0; i < F.size(); ++i)
        for (std::size_t j = i + 1; j < F.size(); ++j) {
            Rng rng{3, std::int64_t(i), std::int64_t(j), 0};
            F(i, j) = F(j, i) = sampled_form_factor(patches.shapes[i], patches.shapes[j], open, 2, rng);
        }
    return F;
}

/// Where patches of one area reflect 0.9 and the first face's emit 1: the light that is absorbed over that emitted,
/// less 1.
[[nodiscard]] inline double energy_defect(const FormFactorMatrix& F) {
    constexpr double       rho   = 0.9;
    const std::size_t      lamps = F.size() / 6;
    std::vector<GreyPatch> patches(F.size(), {rho, 0});
    for (std::size_t i = 0; i < lamps; ++i) patches[i].emission = 1;
    const auto factor   = [&](std::size_t i, std::size_t j) { return F(i, j); };
    double     absorbed = 0;
    for (const auto& B : direct_solution(grey_system(patches, factor))) absorbed += (1 - rho) / rho * B.r;
    absorbed -= (1 - rho) / rho * double(lamps);  // (B - E) / rho is what arrives
    return absorbed / double(lamps) - 1;
}

/// The table of three cures.
inline void compare_closures(course::Chapter& chapter) {
    const auto                rough = rough_factors_of_cube();
    const std::vector<double> areas(rough.size(), 1.0 / 9);
    const auto                normalised = with_normalised_rows(rough), scaled = symmetrically_scaled(rough);
    course::Rows              table{{"form factors", "rows off by", "reciprocity off by", "energy off by"}};
    for (const auto& [name, F] :
         {std::pair{"as they come", &rough}, {"rows normalised", &normalised}, {"scaled", &scaled}})
        table.add({name, closure_defect(*F), reciprocity_defect(*F, areas), energy_defect(*F)});
    chapter.say(table);
    const auto claim = [&](const std::string& what, double expected, double measured, double tolerance) {
        chapter.claim("8.4 " + what, {.expected = expected, .measured = measured, .tolerance = tolerance});
    };
    claim("rough factors: rows off by [%]", 34, 100 * closure_defect(rough), 0.5);
    claim("rough factors: energy lost [%]", 22, -100 * energy_defect(rough), 0.5);
    claim("rows normalised: reciprocity off by [%]", 4.4, 100 * reciprocity_defect(normalised, areas), 0.05);
    claim("rows normalised: energy made [%]", 2.4, 100 * energy_defect(normalised), 0.05);
    chapter.claim_at_most("8.4 scaled: rows off by", closure_defect(scaled), 1e-12);
    chapter.claim_at_most("8.4 scaled: energy off by", std::abs(energy_defect(scaled)), 1e-11);
}

}  // namespace sr
