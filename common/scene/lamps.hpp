#pragma once
/// @file lamps.hpp
/// A scene's lamps, the faces that shine, as point lights.

#include <vector>

#include "scene/scene.hpp"

namespace sr {

/// A point light in the middle of each lamp: of faces of one material that share vertices, and through them others.
/// Its intensity [W/sr], in the scene's unit of length, is that of a flat lamp along its normal, L A; of a closed one
/// it is the mean over all directions, L A / 4, as a convex body's silhouette has a quarter of its surface (Cauchy).
/// From afar a small lamp looks the same; a flat one would be darker from aside, and near it, shadows would have soft
/// edges.
[[nodiscard]] std::vector<PointLight> lights_of_lamps(const Scene& scene);

/// What casts shadows: all but the lamps, which their own lights stand in.
[[nodiscard]] Scene without_lamps(Scene scene);

}  // namespace sr
