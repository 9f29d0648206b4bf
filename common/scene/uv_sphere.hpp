#pragma once
/// @file uv_sphere.hpp

#include "geometry/mesh.hpp"

namespace sr {

/// The finest one: a million triangles.
inline constexpr int max_uv_sphere_bands = 512;

/// A closed sphere of radius 1 around the origin, cut as a globe is: `bands` from pole to pole along z and twice
/// as many around, hence 4 bands^2 - 4 bands triangles. Faces look outwards; the poles are where many edges meet.
/// @pre 2 <= bands <= max_uv_sphere_bands
/// @throws std::invalid_argument otherwise
[[nodiscard]] Mesh<double> uv_sphere(int bands);

}  // namespace sr
