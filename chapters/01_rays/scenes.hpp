#pragma once
/// @file scenes.hpp
/// The two scenes of chapter 1 and their cameras.

#include "scene/camera.hpp"
#include "scene/cornell_box.hpp"
#include "scene/scene.hpp"
#include "scene/scene_view.hpp"
#include "scene/teapot.hpp"

namespace sr {

using Shot = SceneView;

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

}  // namespace sr
