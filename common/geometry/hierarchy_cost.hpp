#pragma once
/// @file hierarchy_cost.hpp
/// The surface-area heuristic: what a hierarchy is expected to cost a random line.

#include <concepts>
#include <cstdint>
#include <optional>

#include "geometry/hierarchy_node.hpp"
#include "geometry/hierarchy_set.hpp"

namespace sr {

/// What looking at a node costs, its two boxes, in units of a triangle's test: c of equation (4.9).
template <std::floating_point T>
inline constexpr T node_cost = T(1);

/// What a line that meets the root's box is expected to ask on its way, equation (4.9).
struct ExpectedWork {
    double nodes     = 0;
    double triangles = 0;

    [[nodiscard]] double cost() const { return node_cost<double> * nodes + triangles; }
};

/// A line that meets a convex body meets another one in it with the chance S_inner / S_outer. So each node and
/// each leaf's triangles count as much as their box's surface does in the root's. It is the expectation for
/// isotropic lines that nothing stops. Where the root's box has no surface, nobody meets it: no work.
/// @see Goldsmith & Salmon, Automatic Creation of Object Hierarchies for Ray Tracing, IEEE CG&A 7(5), 1987
template <std::floating_point T>
[[nodiscard]] ExpectedWork expected_work(const HierarchyTree<T>& tree) {
    if (tree.root.is_leaf() || tree.triangles.empty()) return {0, double(tree.root.count)};
    const double whole = double(tree.box.half_area());
    if (!(whole > 0)) return {};
    ExpectedWork work{1, 0};
    for (const auto& node : tree.nodes) {
        for (std::size_t side = 0; side < 2; ++side) {
            const double chance = double(node.box[side].half_area()) / whole;
            if (node.child[side].is_leaf())
                work.triangles += chance * node.child[side].count;
            else
                work.nodes += chance;
        }
    }
    return work;
}

/// The cost of a cut, half of (4.10): a node, and each half's triangles times the chance to enter it.
/// @param near_half  its number of triangles times half its box's surface; so `far_half`
template <std::floating_point T>
[[nodiscard]] T cut_cost(const BoxSet<T>& set, T near_half, T far_half) {
    return node_cost<T> * set.box.half_area() + near_half + far_half;
}

/// Leaves hold no more triangles, whatever the cost.
inline constexpr std::uint32_t largest_leaf = 8;

/// Whether a small set is better asked triangle by triangle than cut at the cheapest place, if there is one.
template <std::floating_point T>
[[nodiscard]] bool is_best_as_leaf(const BoxSet<T>& set, std::optional<T> cheapest_cut) {
    if (set.count() > largest_leaf) return false;
    return !(cheapest_cut && *cheapest_cut < T(set.count()) * set.box.half_area());
}

}  // namespace sr
