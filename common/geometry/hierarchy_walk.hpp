#pragma once
/// @file hierarchy_walk.hpp
/// How a ray walks a binary hierarchy.

#include <array>
#include <concepts>
#include <cstdint>

#include "geometry/hierarchy_node.hpp"

namespace sr {

/// How much work walks were. Uncounted ones cost nothing more.
struct WalkCount {
    std::uint64_t nodes     = 0;  ///< at each, the boxes of both children were asked
    std::uint64_t triangles = 0;

    void add_node() { ++nodes; }
    void add_triangles(std::uint32_t more) { triangles += more; }
};
struct Uncounted {
    static constexpr void add_node() {}
    static constexpr void add_triangles(std::uint32_t) {}
};

/// Offers the triangles of the leaves that the ray passes through, nearer child first, until the search's
/// range is empty. A box is left out only where it begins beyond the range: at equal t another face may win.
/// @param search  with `offer(triangle)`, the ray's `boxes()` and the `range()` that is still of interest
template <std::floating_point T, class Search, class Count>
void walk(const HierarchyTree<T>& tree, Search& search, Count& count) {
    using Child = typename HierarchyNode<T>::Child;
    /// A child that has to wait for its nearer sibling, and where the ray enters it.
    struct Waiting {
        Child child;
        T     near;
    };
    std::array<Waiting, HierarchyTree<T>::max_depth> stack;
    std::size_t                                      waiting = 0;

    const BoxRay<T> boxes = search.boxes();
    Interval<T>     range = search.range();
    Child           here  = tree.root;
    if (tree.triangles.empty() || (!here.is_leaf() && boxes.clip(tree.box, range).empty())) return;
    for (;;) {
        if (!here.is_leaf()) {
            count.add_node();
            const HierarchyNode<T>& node    = tree.nodes[here.first];
            const Interval<T>       left    = boxes.clip(node.box[0], range);
            const Interval<T>       right   = boxes.clip(node.box[1], range);
            const bool              in_left = !left.empty(), in_right = !right.empty();
            if (in_left && in_right) {
                const bool left_first = left.min <= right.min;
                stack[waiting++] =
                    left_first ? Waiting{node.child[1], right.min} : Waiting{node.child[0], left.min};
                here = node.child[left_first ? 0 : 1];
                continue;
            }
            if (in_left || in_right) {
                here = node.child[in_left ? 0 : 1];
                continue;
            }
        } else {
            count.add_triangles(here.count);
            for (std::uint32_t i = 0; i < here.count; ++i) search.offer(tree.triangles[here.first + i]);
            range = search.range();
            if (range.empty()) return;
        }
        do {
            if (waiting == 0) return;
            --waiting;
        } while (stack[waiting].near > range.max);
        here = stack[waiting].child;
    }
}

}  // namespace sr
