#pragma once
/// @file cornell_box.hpp
/// The Cornell box: a real box of plywood and paint, measured in millimetres so that a render could be held
/// against a photograph. The data are those of the Cornell University Program of Computer Graphics.

#include "scene/camera.hpp"
#include "scene/scene.hpp"

namespace sr {

/// The box as published: 32 triangles, walls and two blocks, open towards the camera. The light lies 0.1
/// below the ceiling, whose plane it shares in the original, and shines from its front only: what its back would give
/// lights a ring of ceiling as narrow as the gap, and as bright as the lamp.
/// @throws std::runtime_error when the file of its data can't be read
[[nodiscard]] Scene cornell_box();

/// The walls and the lamp of the box; in place of the blocks a ball of mirror and one of glass, n = 1.5. It is lit by
/// a point light of warm white below the lamp.
/// @throws std::runtime_error when the file of its data can't be read
[[nodiscard]] Scene cornell_box_with_balls();

/// The published lens and film, lengths in another unit than the box: only their ratio matters to a pinhole.
namespace cornell_camera {
inline constexpr double focal_length = 0.035;
inline constexpr double film_side    = 0.025;  ///< width and height
}  // namespace cornell_camera

/// The published camera, which sees the box through its open side.
/// @param side  of the square image [pixel]
[[nodiscard]] Camera<double> cornell_box_camera(int side);

}  // namespace sr
