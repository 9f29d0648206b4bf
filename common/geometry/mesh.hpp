#pragma once
/// @file mesh.hpp

#include <array>
#include <concepts>
#include <cstdint>
#include <vector>

#include "geometry/triangle.hpp"
#include "math/vector.hpp"

namespace sr {

/// Triangles that share vertices. Neighbours name the same vertex, so that an edge has one position and not
/// two that nearly agree. The front of a face is where its vertices run counter-clockwise.
template <std::floating_point T>
struct Mesh {
    using Face = std::array<std::uint32_t, 3>;

    std::vector<Vector3<T>> vertices;
    std::vector<Face>       faces;

    [[nodiscard]] Triangle<T> triangle(std::size_t face) const {
        const auto [a, b, c] = faces[face];
        return {vertices[a], vertices[b], vertices[c]};
    }
};

/// The same mesh in another precision; each coordinate is rounded once.
template <std::floating_point To, std::floating_point From>
[[nodiscard]] Mesh<To> convert(const Mesh<From>& mesh) {
    return {{mesh.vertices.begin(), mesh.vertices.end()}, mesh.faces};
}

}  // namespace sr
