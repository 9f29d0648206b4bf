#pragma once
/// @file neighbours.hpp
/// Which faces of a mesh meet at a vertex: all that a ray aimed at it may hit.

#include <algorithm>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include "geometry/mesh.hpp"

namespace sr {

class Neighbours {
public:
    explicit Neighbours(const Mesh<double>& mesh)
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

}  // namespace sr
