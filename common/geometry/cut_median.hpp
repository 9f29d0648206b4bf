#pragma once
/// @file cut_median.hpp

#include <concepts>
#include <cstdint>
#include <optional>

#include "geometry/hierarchy_set.hpp"

namespace sr {

/// Cuts a set into halves of equally many triangles, wherever they are: the plain way.
template <std::floating_point T>
class MedianCut : public ReferenceList<T> {
public:
    using ReferenceList<T>::ReferenceList;

    /// Where the far half begins, after bringing the set's references into that order; none for a leaf.
    std::optional<std::uint32_t> cut(const BoxSet<T>& set) {
        constexpr std::uint32_t leaf = 4;
        if (set.count() <= leaf) return std::nullopt;
        return this->halve(set);
    }
};

}  // namespace sr
