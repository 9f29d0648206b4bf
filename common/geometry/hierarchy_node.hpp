#pragma once
/// @file hierarchy_node.hpp
/// How a binary hierarchy of boxes lies in memory.

#include <array>
#include <concepts>
#include <cstdint>
#include <vector>

#include "geometry/box.hpp"
#include "geometry/nearest.hpp"

namespace sr {

/// One decision of a binary hierarchy. The boxes of both children lie in the parent: a ray reads 64 bytes,
/// one cache line in float, and knows which children to visit and which first.
template <std::floating_point T>
struct alignas(16 * sizeof(T)) HierarchyNode {
    std::array<Box<T>, 2> box;

    /// A child is a leaf where count > 0: `count` triangles from `first` on. Else `first` is its node.
    struct Child {
        std::uint32_t      first;
        std::uint32_t      count;
        [[nodiscard]] bool is_leaf() const { return count > 0; }
    };
    std::array<Child, 2> child{};
};
static_assert(sizeof(HierarchyNode<float>) == 64);

/// All of a hierarchy. Without triangles there is nothing to visit; a root that is a leaf needs no node.
template <std::floating_point T>
struct HierarchyTree {
    /// No leaf lies deeper below the root.
    static constexpr std::size_t max_depth = 96;

    Box<T>                           box;  ///< around everything
    typename HierarchyNode<T>::Child root{0, 0};
    std::vector<HierarchyNode<T>>    nodes;
    std::vector<FaceTriangle<T>>     triangles;  ///< in the order of the leaves
};

}  // namespace sr
