#pragma once
/// @file cornell_solution.hpp
/// The Cornell box, cut into patches and solved.

#include <string_view>
#include <utility>
#include <vector>

#include "course/chapter.hpp"
#include "radiosity/conjugate_gradients.hpp"
#include "radiosity/form_factors.hpp"
#include "radiosity/patch_system.hpp"
#include "radiosity/system_check.hpp"
#include "radiosity/vertex_radiosity.hpp"
#include "scene/cornell_box.hpp"

namespace sr {

/// Patches of a scene and the light that they have.
struct SolvedScene {
    Patches         patches;
    RadiositySystem system;
    Radiosities     radiosities;
    Radiosities     at_vertices;
    double          seconds;  ///< for form factors and solution
};

inline constexpr double factor_tolerance = 1e-2;  ///< of form factors, and of the sums of their rows

/// Solves what is cut already; only the scene's own faces hide anything.
/// @param noise by how much more the rows may exceed 1. Form factors keep their tolerance, but what two patches see of
///              each other is the share of 16 rays: of the published box no row has more than 1.006, and in patches of
///              90 mm none more than 1.005; large patches that touch what hides them, as in other scenes, have more
/// @throws std::invalid_argument if there is no solution that is light, see check_system
[[nodiscard]] inline SolvedScene solve_patches(Patches patches, const Mesh<double>& scene, int threads,
                                               double noise = 0) {
    course::Progress progress("computing form factors", int(patches.size()));
    SolvedScene      solved{std::move(patches), {FormFactorMatrix(0), {}, {}, {}}, {}, {}, 0};
    solved.seconds     = course::seconds_of([&] {
        const RowLoop rows{threads, [&](int, int) { progress.tick(); }};
        solved.system = system_of(solved.patches, form_factors(solved.patches, Visibility(scene),
                                                                   {.tolerance = factor_tolerance}, rows));
        check_system(solved.system, factor_tolerance + noise);
        solved.radiosities = solution_by(ConjugateGradients(solved.system, threads), 1e-6, 1000);
    });
    solved.at_vertices = vertex_radiosities(solved.patches, solved.radiosities);
    return solved;
}

/// The published box, its patches no longer than `size` [mm].
[[nodiscard]] inline SolvedScene solve_cornell_box(double size, int threads) {
    const Scene box = cornell_box();
    return solve_patches(cut(polygons_of(box), size), box.mesh, threads);
}

/// What the walls and blocks are called in the box, and how many polygons each of them is.
struct NamedPart {
    std::string_view name;
    std::uint32_t    polygons;
};
inline constexpr NamedPart parts_of_the_box[] = {{"floor", 1},       {"ceiling", 1},   {"back wall", 1},
                                                 {"green wall", 1},  {"red wall", 2},  {"lamp", 1},
                                                 {"short block", 5}, {"tall block", 5}};

}  // namespace sr
