#pragma once
/// @file obj.hpp

#include <filesystem>
#include <functional>
#include <string_view>

#include "scene/scene.hpp"

namespace sr {

/// Is told, a line each, what is taken otherwise than a file has it.
using Note = std::function<void(std::string_view)>;

/// Reads the triangles and materials of a Wavefront OBJ file and of the MTL files that it names.
///  A face of n > 3 corners becomes the fan (0,1,2), (0,2,3), ..., or if it is not convex, that from the first corner
/// that sees it whole; a face without such a corner is refused. Faces without a material get a neutral grey of
/// reflectance 0.8. Normals, texture coordinates, groups, smoothing, lines and points are passed over.
///
/// Of a material, Ke is the emission, and `illum` says how it scatters:
///     2            Phong's lobe with the weight Ks and the exponent Ns, or 20 if there is none, beside a diffuse lobe
///                  with Kd. Where Kd + Ks is more than 1 in a channel, both are divided by that, and `note` is told
///     3, 5         a mirror with the weight Ks beside a diffuse lobe with Kd
///     4, 6, 7, 9   clear glass of the index of refraction Ni, or of 1.5 if there is none. Such a mesh must be closed,
///                  and its faces look outwards
///     all others   diffuse, with the reflectance Kd, whatever Ks is
/// @return a scene whose numbers are finite, also in float, and whose indices are in range
/// @throws std::runtime_error of one line, "file:line: what is wrong; what would be right"
[[nodiscard]] Scene read_obj(
    const std::filesystem::path& path, const Note& note = [](std::string_view) {});

}  // namespace sr
