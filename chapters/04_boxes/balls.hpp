#pragma once
/// @file balls.hpp
/// What if each box of a hierarchy were the ball around the same triangles?

#include <algorithm>
#include <cmath>
#include <numbers>

#include "geometry/hierarchy_node.hpp"

namespace sr {

/// Sums over all nodes and leaves below the root: twice as much surface, twice as many random lines enter.
struct SurfaceSums {
    double boxes = 0, balls = 0;
};

/// The radius of the ball around the box's centre that holds the child's triangles.
[[nodiscard]] inline double radius_around(const HierarchyTree<float>& tree, HierarchyNode<float>::Child child,
                                          Vec3 centre) {
    if (!child.is_leaf()) {
        const auto& node = tree.nodes[child.first];
        return std::max(radius_around(tree, node.child[0], centre),
                        radius_around(tree, node.child[1], centre));
    }
    float radius = 0;
    for (std::uint32_t i = 0; i < child.count; ++i) {
        const auto& triangle = tree.triangles[child.first + i].triangle;
        for (const Vec3& vertex : {triangle.a, triangle.b, triangle.c})
            radius = std::max(radius, length(vertex - centre));
    }
    return double(radius);
}

[[nodiscard]] inline SurfaceSums surfaces(const HierarchyTree<float>& tree) {
    SurfaceSums sum;
    for (const auto& node : tree.nodes) {
        for (std::size_t side = 0; side < 2; ++side) {
            const double r = radius_around(tree, node.child[side], node.box[side].centre());
            sum.boxes += 2 * double(node.box[side].half_area());
            sum.balls += 4 * std::numbers::pi * r * r;
        }
    }
    return sum;
}

}  // namespace sr
