#pragma once
/// @file teapot.hpp

#include "geometry/mesh.hpp"

namespace sr {

/// The finest level: 16 million triangles, 0.4 GB of mesh.
inline constexpr int max_teapot_level = 500;

/// The teapot that Martin Newell modelled at Utah in 1975, z up, about 6.5 long and 3.15 high: 32 bicubic
/// Bezier patches, each cut into level x level quadrilaterals of two triangles. Triangles without an area, which
/// the poles of the lid and of the bottom make, are left out: 64 level^2 - 8 level remain (52 at level 1, whose
/// handle and spout are flat). Faces look outwards, and patches that meet share their vertices. The surface ends
/// at the rim and the lid, between which is a gap, and at both ends of handle and spout.
/// @pre 1 <= level <= max_teapot_level
/// @throws std::invalid_argument otherwise
/// @throws std::runtime_error when the file of its patches can't be read
[[nodiscard]] Mesh<double> teapot(int level);

}  // namespace sr
