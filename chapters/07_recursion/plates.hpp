#pragma once
/// @file plates.hpp
/// Section 7.4: a pile of glass plates before a lamp, where rays bounce to and fro and all that comes through is known.

#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include "statistics/running.hpp"
#include "transport/recursion.hpp"

namespace sr {

/// A square of side 20 across the z axis whose normal is along z, upwards or downwards.
inline void add_square(Scene& scene, double z, bool up, std::uint32_t material) {
    const auto first = std::uint32_t(scene.mesh.vertices.size());
    for (const auto& [x, y] : {std::pair{-10.0, -10.0}, {10.0, -10.0}, {10.0, 10.0}, {-10.0, 10.0}})
        scene.mesh.vertices.emplace_back(x, y, z);
    for (const std::uint32_t i : {1U, 2U}) {
        const Mesh<double>::Face face{first, first + i, first + i + 1};
        scene.mesh.faces.push_back(up ? face : Mesh<double>::Face{face[0], face[2], face[1]});
        scene.material_of_face.push_back(material);
    }
}

/// So many plates of glass from z = 1 on, and beyond them a lamp of radiance 1.
[[nodiscard]] inline Scene pile_of_plates(int plates, float n = 1.5F) {
    Scene scene;
    scene.materials = {{"glass", LobeSum<float>{{{{1, 1, 1}, Dielectric<float>{n}}}}},
                       diffuse_material("lamp", {}, {1, 1, 1})};
    for (int i = 1; i <= plates; ++i) {
        add_square(scene, i, false, 0);
        add_square(scene, i + 0.5, true, 0);
    }
    add_square(scene, plates + 1, false, 1);
    return scene;
}

/// What comes through at right angles, of all bounces, (7.8).
[[nodiscard]] inline double transmittance(int plates, double R) {
    return (1 - R) / (1 + (2 * plates - 1) * R);
}

/// What was seen through the plates, and the rays that it took.
struct SeenThrough {
    Running       radiance;
    std::uint64_t rays = 0;
};

/// @param trees  how many; where branches are not random, all of them are the same
[[nodiscard]] inline SeenThrough look_through_plates(int plates, const RecursionOptions& options,
                                                     int trees = 1) {
    const RecursiveTracer tracer(pile_of_plates(plates), options);
    SeenThrough           seen;
    for (int tree = 0; tree < trees; ++tree) {
        Rng      rng{7, 0, 0, tree};
        RayCount count;
        seen.radiance.add(double(tracer.radiance({{0.3F, 0.2F, 0}, {0, 0, 1}}, rng, count).g));
        seen.rays += count.rays;
    }
    return seen;
}

}  // namespace sr
