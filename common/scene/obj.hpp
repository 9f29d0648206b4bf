#pragma once
/// @file obj.hpp

#include <filesystem>

#include "scene/scene.hpp"

namespace sr {

/// Reads the triangles and materials of a Wavefront OBJ file and of the MTL files that it names.
///
/// A face of n > 3 corners becomes the fan (0,1,2), (0,2,3), ...: polygons must be convex. Of a material, Kd
/// is the reflectance and Ke the emission; faces without one get a neutral grey of reflectance 0.8. Normals,
/// texture coordinates, groups, smoothing, lines and points are passed over.
/// @return a scene whose numbers are finite, also in float, and whose indices are in range
/// @throws std::runtime_error of one line, "file:line: what is wrong; what would be right"
[[nodiscard]] Scene read_obj(const std::filesystem::path& path);

}  // namespace sr
