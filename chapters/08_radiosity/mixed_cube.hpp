#pragma once
/// @file mixed_cube.hpp
/// The inside of a unit cube whose faces reflect 10, 20, ... 60 %; the last, the ceiling, shines. Nothing hides
/// anything in it, so that each form factor from a point is exact.

#include <vector>

#include "gather.hpp"
#include "lit_room.hpp"
#include "radiosity/form_factors.hpp"
#include "radiosity/patch_system.hpp"
#include "radiosity/relaxed_jacobi.hpp"
#include "radiosity/rows.hpp"
#include "radiosity/vertex_radiosity.hpp"

namespace sr {

[[nodiscard]] inline std::vector<Polygon> mixed_cube() {
    auto faces = inside_of_a_cube();
    for (std::size_t face = 0; face < 6; ++face) faces[face].reflectance = grey(0.1 * double(face + 1));
    faces[5].emission = grey(1);
    return faces;
}

/// Form factors as seen from each patch's centre, in place of their means over the patch: collocation.
[[nodiscard]] inline FormFactorMatrix form_factors_of_centres(const Patches& patches, int threads) {
    FormFactorMatrix F(patches.size());
    for_each_row(patches.size(), {threads}, [&](std::size_t i) {
        const Patch& from = patches.shapes[i];
        for (std::size_t j = 0; j < patches.size(); ++j)
            F(i, j) = contour_form_factor(from.centre(), from.normal(), patches.shapes[j]);
    });
    return F;
}

/// From where form factors are measured.
enum class Measured { from_means, from_centres };

/// The cube, each face n x n patches, and their radiosities.
struct CubeSolution {
    int         n;
    Patches     patches;
    Radiosities radiosities;
    Radiosities at_vertices;
};

[[nodiscard]] inline CubeSolution solve_mixed_cube(int n, Measured measured, int threads) {
    CubeSolution     cube{n, cut(mixed_cube(), 1.0 / n), {}, {}};
    const Visibility nothing_hides{Mesh<double>{}};
    const auto       system =
        system_of(cube.patches, measured == Measured::from_centres
                                    ? form_factors_of_centres(cube.patches, threads)
                                    : form_factors(cube.patches, nothing_hides, {}, {threads}));
    cube.radiosities = solution_by(RelaxedJacobi(system, 1, threads), 1e-10, 100);
    cube.at_vertices = vertex_radiosities(cube.patches, cube.radiosities);
    return cube;
}

/// The mean of a face.
[[nodiscard]] inline double mean_of_face(const CubeSolution& cube, std::size_t face) {
    const std::size_t patches = std::size_t(cube.n) * std::size_t(cube.n);
    double            sum     = 0;
    for (std::size_t k = 0; k < patches; ++k) sum += cube.radiosities[face * patches + k].r;
    return sum / double(patches);
}

}  // namespace sr
