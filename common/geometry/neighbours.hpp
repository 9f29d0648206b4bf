#pragma once
/// @file neighbours.hpp
/// Which faces of a mesh meet at a vertex: all that a ray aimed at it may hit, and one of them it has to.

#include <algorithm>
#include <concepts>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include "geometry/mesh.hpp"
#include "geometry/triangle.hpp"
#include "math/vector.hpp"

namespace sr {

/// The faces around each vertex, and which vertices they enclose without a gap.
class Neighbours {
public:
    template <std::floating_point T>
    explicit Neighbours(const Mesh<T>& mesh)
        : faces_(mesh.vertices.size()), closed_(mesh.vertices.size(), true) {
        std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
        for (std::uint32_t face = 0; face < mesh.faces.size(); ++face) {
            for (std::size_t i = 0; i < 3; ++i) {
                const auto a = mesh.faces[face][i], b = mesh.faces[face][(i + 1) % 3];
                faces_[a].push_back(face);
                ++edges[std::minmax(a, b)];
            }
        }
        edges_ = std::int64_t(edges.size());
        for (const auto& [ends, sides] : edges) {
            if (sides != 2) closed_[ends.first] = closed_[ends.second] = false;
        }
    }

    [[nodiscard]] const std::vector<std::uint32_t>& around(std::uint32_t vertex) const {
        return faces_[vertex];
    }

    /// Whether the faces around the vertex enclose it without a gap.
    [[nodiscard]] bool closed(std::uint32_t vertex) const { return closed_[vertex]; }

    [[nodiscard]] std::int64_t edges() const { return edges_; }

private:
    std::vector<std::vector<std::uint32_t>> faces_;
    std::vector<bool>                       closed_;
    std::int64_t                            edges_ = 0;
};

/// Whether all faces around the vertex show the point the same side, and none is seen edge-on: a ray from there to
/// the vertex can't pass between them, whatever its rounding.
template <std::floating_point T>
[[nodiscard]] bool walls_off(const Mesh<T>& mesh, const Neighbours& neighbours, std::uint32_t vertex,
                             const Vector3<T>& point) {
    if (!neighbours.closed(vertex) || neighbours.around(vertex).empty()) return false;
    constexpr T edge_on = T(0.02);  // a cosine
    const auto  towards = normalize(point - mesh.vertices[vertex]);
    bool        front = false, back = false;
    for (const auto face : neighbours.around(vertex)) {
        const T cosine = dot(normalize(area_vector(mesh.triangle(face))), towards);
        front          = front || !(cosine <= -edge_on);
        back           = back || !(cosine >= edge_on);
    }
    return front != back;
}

}  // namespace sr
