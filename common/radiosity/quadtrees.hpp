#pragma once
/// @file quadtrees.hpp

#include <cstdint>
#include <span>
#include <vector>

#include "radiosity/patches.hpp"
#include "radiosity/radiosity_system.hpp"

namespace sr {

/// A polygon, or a quarter of a node: one patch where it is a leaf, many as one where it isn't.
struct QuadtreeNode {
    Patch         shape;
    std::uint32_t polygon;
    std::uint32_t first_child = 0;  ///< of four that follow each other; a leaf has none: 0

    [[nodiscard]] bool is_leaf() const { return first_child == 0; }
};

/// Polygons, each cut into patches of many sizes. The polygons are the first nodes, in their order, and each node
/// comes before its children.
class Quadtrees {
public:
    explicit Quadtrees(std::span<const Polygon> polygons);

    [[nodiscard]] std::size_t         size() const { return nodes_.size(); }
    [[nodiscard]] const QuadtreeNode& operator[](std::size_t node) const { return nodes_[node]; }
    [[nodiscard]] const Polygon&      polygon_of(std::size_t node) const {
             return polygons_[nodes_[node].polygon];
    }
    [[nodiscard]] std::size_t polygon_count() const { return polygons_.size(); }
    [[nodiscard]] std::size_t leaf_count() const { return size() - (size() - polygons_.size()) / 4; }

    /// The first of a node's four children, which it is given if it has none.
    std::uint32_t children(std::uint32_t node);

    /// Irradiances that nodes of all levels gathered become their radiosities, equation (8.30): a leaf gets what all
    /// nodes above it gathered, too, and any other node has the mean of its children, by area [W/m^2].
    [[nodiscard]] Radiosities push_pull(Radiosities gathered) const;

    /// The leaves as patches, and their radiosities from those of all nodes, in the same order. They share no
    /// vertices, since corners of small ones lie within sides of large ones: vertex_radiosities() would find nothing to
    /// interpolate between.
    [[nodiscard]] Patches     leaves() const;
    [[nodiscard]] Radiosities of_leaves(const Radiosities& radiosities) const;

    [[nodiscard]] std::size_t bytes() const;  ///< of memory

private:
    std::vector<Polygon>      polygons_;
    std::vector<QuadtreeNode> nodes_;
};

}  // namespace sr
