#pragma once
/// @file small_scenes.hpp
/// What small scenes with known light are made of.

#include <array>
#include <cstdint>

#include "scene/scene.hpp"

namespace sr {

[[nodiscard]] inline Material grey(float reflectance, float emission = 0) {
    return diffuse_material("grey", {reflectance, reflectance, reflectance}, {emission, emission, emission});
}

inline void add_quad(Scene& scene, const std::array<Vector3<double>, 4>& corners, std::uint32_t material) {
    const auto first = std::uint32_t(scene.mesh.vertices.size());
    scene.mesh.vertices.insert(scene.mesh.vertices.end(), corners.begin(), corners.end());
    scene.mesh.faces.push_back({first, first + 1, first + 2});
    scene.mesh.faces.push_back({first, first + 2, first + 3});
    scene.material_of_face.insert(scene.material_of_face.end(), 2, material);
}

/// The six sides of a cube, each of a material of its own: x = low, x = high, y = low, ... are 0, 1, 2, ...
inline void add_cube(Scene& scene, double low, double high) {
    for (std::uint32_t side = 0; side < 6; ++side) {
        const int                      axis = int(side / 2);
        std::array<Vector3<double>, 4> corners;
        for (int k = 0; k < 4; ++k) {
            Vector3<double> p{};
            p[axis]                 = side % 2 == 0 ? low : high;
            p[(axis + 1) % 3]       = k == 1 || k == 2 ? high : low;
            p[(axis + 2) % 3]       = k >= 2 ? high : low;
            corners[std::size_t(k)] = p;
        }
        add_quad(scene, corners, side);
    }
}

/// The inside of a ball that reflects and emits the same everywhere.
[[nodiscard]] inline Scene inside_of_a_ball(float reflectance, float emission) {
    Scene scene;
    scene.materials = {grey(reflectance, emission)};
    scene.balls     = {{Sphere<double>{{0, 0, 0}, 1}, 0}};
    return scene;
}

}  // namespace sr
