#pragma once
/// @file hierarchy_node.hpp

#include <array>
#include <concepts>
#include <cstdint>

#include "geometry/box.hpp"

namespace sr {

/// One decision of a binary hierarchy. The boxes of both children lie in the parent: a ray reads 64 bytes,
/// one cache line in float, and knows which children to visit and which first.
template <std::floating_point T>
struct alignas(16 * sizeof(T)) HierarchyNode {
    std::array<Box<T>, 2> box;

    /// A child is a leaf where count > 0: `count` triangles from `first` on. Else `first` is its node.
    struct Child {
        std::uint32_t first;
        std::uint32_t count;
    };
    std::array<Child, 2> child{};
};
static_assert(sizeof(HierarchyNode<float>) == 64);

}  // namespace sr
