#pragma once
/// @file box_of_balls.hpp

#include "scene/cornell_box.hpp"
#include "scene/scene_view.hpp"

namespace sr {

/// The box with a ball of mirror and one of glass, lit by its lamp alone.
[[nodiscard]] inline SceneView box_of_balls(int side) {
    SceneView view{cornell_box_with_balls(), cornell_box_camera(side)};
    view.scene.lights.clear();
    return view;
}

}  // namespace sr
