#pragma once
/// @file boxes.hpp
/// The scenes of chapter 7.

#include "scene/cornell_box.hpp"
#include "scene/scene_view.hpp"

namespace sr {

[[nodiscard]] inline SceneView box_with_balls(int side) {
    return {cornell_box_with_balls(), cornell_box_camera(side)};
}

/// The original box, with the same light.
[[nodiscard]] inline SceneView box_of_paint(int side) {
    SceneView view{cornell_box(), cornell_box_camera(side)};
    view.scene.lights = cornell_box_with_balls().lights;
    return view;
}

}  // namespace sr
