/// @file scene_view.cpp

#include "scene/scene_view.hpp"

#include <algorithm>
#include <numbers>
#include <utility>

#include "geometry/box.hpp"
#include "scene/lamps.hpp"

namespace sr {

SceneView view_of_file(const std::filesystem::path& file, int side, const Note& note) {
    Scene       scene = read_obj(file, note);
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

SceneView lit_view_of_file(const std::filesystem::path& file, int side, const Note& note) {
    SceneView view    = view_of_file(file, side, note);
    view.scene.lights = lights_of_lamps(view.scene);
    if (view.scene.lights.empty()) {
        const Vector3<double> upper_left{-1.5, 2.5, 2};
        const float           I = std::numbers::pi_v<float> * float(dot(upper_left, upper_left));
        view.scene.lights.push_back({upper_left, {I, I, I}});
    }
    view.scene.background = {0.08F, 0.1F, 0.13F};
    return view;
}

}  // namespace sr
