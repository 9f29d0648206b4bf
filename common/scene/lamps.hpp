#pragma once
/// @file lamps.hpp

#include <vector>

#include "scene/scene.hpp"

namespace sr {

/// A point light in place of each material that shines: in the middle of its faces, with the sum of what they send
/// along their normals, I = L A [W/sr] in the scene's unit of length. From afar and from before it, a small flat lamp
/// looks the same; beside it, it would be darker, and near it, shadows would have soft edges.
[[nodiscard]] std::vector<PointLight> lights_of_lamps(const Scene& scene);

}  // namespace sr
