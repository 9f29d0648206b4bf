#pragma once
/// @file scenes.hpp
/// The two scenes of chapter 1 and their cameras, and a view of any scene that a reader brings along.

#include <algorithm>
#include <filesystem>
#include <utility>

#include "geometry/box.hpp"
#include "scene/camera.hpp"
#include "scene/cornell_box.hpp"
#include "scene/obj.hpp"
#include "scene/scene.hpp"
#include "scene/teapot.hpp"

namespace sr {

/// A scene and where it is seen from.
struct Shot {
    Scene          scene;
    Camera<double> camera;
};

[[nodiscard]] inline Shot cornell_shot(int side) {
    return {cornell_box(), cornell_box_camera(side)};
}

[[nodiscard]] inline Scene teapot_scene(int level) {
    Scene scene{teapot(level), {diffuse_material("glazed clay", {0.75F, 0.75F, 0.75F})}, {}};
    scene.material_of_face.assign(scene.mesh.faces.size(), 0);
    return scene;
}

[[nodiscard]] inline Camera<double> teapot_camera(int width, int height) {
    const Vector3<double> eye{2.6, -8.2, 4.2}, target{0.32, 0, 1.4};
    return pinhole_camera<double>(eye, target - eye, {0, 0, 1}, 1.0, 0.86, width, height);
}

[[nodiscard]] inline Shot teapot_shot(int level, int width) {
    return {teapot_scene(level), teapot_camera(width, width * 5 / 8)};
}

/// A file's scene from the front, a little above and from the right, filling the picture; y is up. It is moved
/// to the origin and scaled to radius 1, so that no file is too large or too far away for float.
[[nodiscard]] inline Shot shot_of_file(const std::filesystem::path& file, int side) {
    Scene       scene = read_obj(file);
    Box<double> box;
    for (const auto& face : scene.mesh.faces) {
        for (const auto vertex : face) box.include(scene.mesh.vertices[vertex]);
    }
    const double radius = std::max(length(box.size()) / 2, 1e-300);
    for (auto& vertex : scene.mesh.vertices) vertex = (vertex - box.centre()) / radius;

    const Vector3<double> towards_eye = normalize(Vector3<double>{0.4, 0.35, 1});
    return {std::move(scene),
            pinhole_camera<double>(2.6 * towards_eye, -towards_eye, {0, 1, 0}, 1.0, 0.85, side, side)};
}

}  // namespace sr
