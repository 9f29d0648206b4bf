#pragma once
/// @file scene_view.hpp

#include <filesystem>

#include "scene/camera.hpp"
#include "scene/obj.hpp"
#include "scene/scene.hpp"

namespace sr {

/// A scene and where it is seen from.
struct SceneView {
    Scene          scene;
    Camera<double> camera;
};

/// A file's scene from the front, a little above and from the right, filling the picture; y is up. It is moved
/// to the origin and scaled to radius 1, so that no file is too large or too far away for float.
/// @param side  of the square image [pixel]
/// @param note  as for read_obj
/// @throws std::runtime_error as read_obj
[[nodiscard]] SceneView view_of_file(
    const std::filesystem::path& file, int side, const Note& note = [](std::string_view) {});

/// The same, lit: by point lights in place of its lamps, or if it has none by one from the upper left, so strong that
/// white paper in the origin that faces it has radiance 1. Behind all is a dark sky, for mirrors and glass to show.
[[nodiscard]] SceneView lit_view_of_file(
    const std::filesystem::path& file, int side, const Note& note = [](std::string_view) {});

}  // namespace sr
