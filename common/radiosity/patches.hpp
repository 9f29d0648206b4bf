#pragma once
/// @file patches.hpp
/// Surfaces cut into patches, each with one radiosity. How to use:
///     const Patches patches = cut(polygons_of(scene), size);
///     patches.shapes[i].area();    // of patch i
///     patches.vertices[patches.corners[i][0]];

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "geometry/mesh.hpp"
#include "radiosity/polygons.hpp"

namespace sr {

/// Patch i is shapes[i]; its corners are vertices, shared with its neighbours in the same polygon.
struct Patches {
    using Corners = std::array<std::uint32_t, 4>;  ///< of a triangle, the last is there twice

    std::vector<Vector3<double>> vertices;
    std::vector<Corners>         corners;
    std::vector<Patch>           shapes;
    std::vector<DoubleSpectrum>  reflectance;  ///< [1]
    std::vector<DoubleSpectrum>  emission;     ///< radiosity [W/m^2]
    std::vector<std::uint32_t>   polygon;      ///< of which it is a part

    [[nodiscard]] std::size_t size() const { return shapes.size(); }
};

/// Each polygon cut evenly, a quadrilateral along both its directions, a triangle into n^2 of its shape, such that no
/// side is longer than `size` [length unit]. Of a sliver so narrow that a piece's corners round to a line, that piece
/// is left out: its vertices stay, and no patch has them.
/// @throws std::invalid_argument if the size is not above 0, or asks for more than `most_patches`
[[nodiscard]] Patches   cut(std::span<const Polygon> polygons, double size);
inline constexpr double most_patches = 1e7;

/// The patches as triangles, to be seen: one each, or two.
struct PatchMesh {
    Mesh<double>               mesh;
    std::vector<std::uint32_t> patch_of_face;
};
[[nodiscard]] PatchMesh mesh_of(const Patches& patches);

}  // namespace sr
