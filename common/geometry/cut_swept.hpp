#pragma once
/// @file cut_swept.hpp

#include <algorithm>
#include <array>
#include <concepts>
#include <cstdint>
#include <limits>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

#include "geometry/hierarchy_cost.hpp"
#include "geometry/hierarchy_set.hpp"

namespace sr {

/// Cuts where the expected cost is least, of all places between two centres along each axis. The triangles are
/// sorted once along each axis, and each cut keeps the three orders.
/// @see Wald & Havran, On building fast kd-Trees for Ray Tracing, and on doing that in O(N log N), 2006
template <std::floating_point T>
class SweptCut {
public:
    explicit SweptCut(std::vector<BoxReference<T>> references)
        : references_(std::move(references)), far_cost_(references_.size()), far_(references_.size()) {
        for (int axis = 0; axis < 3; ++axis) {
            auto& order = orders_[std::size_t(axis)];
            order.resize(references_.size());
            std::iota(order.begin(), order.end(), 0U);
            std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
                return comes_before(references_[a], references_[b], axis);
            });
        }
    }

    [[nodiscard]] std::uint32_t size() const { return std::uint32_t(references_.size()); }
    [[nodiscard]] std::uint32_t triangle(std::uint32_t position) const {
        return references_[orders_[0][position]].triangle;
    }
    [[nodiscard]] BoxSet<T> set(std::uint32_t begin, std::uint32_t end) const {
        BoxSet<T> result{begin, end};
        for (std::uint32_t i = begin; i < end; ++i) result.include(references_[orders_[0][i]]);
        return result;
    }

    /// As MedianCut::cut.
    std::optional<std::uint32_t> cut(const BoxSet<T>& set) {
        std::optional<Place> best;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const Place place = cheapest(set, axis);
            if (!(best && best->cost <= place.cost)) best = place;
        }
        if (is_best_as_leaf(set, std::optional(best->cost))) return std::nullopt;
        return partition(set, best->axis, best->middle);
    }
    std::uint32_t halve(const BoxSet<T>& set) {
        return partition(set, std::size_t(set.longest_axis()), set.begin + set.count() / 2);
    }

private:
    struct Place {
        std::size_t   axis;
        std::uint32_t middle;  ///< the first position on the far side
        T             cost;
    };

    /// Once from the far side, to keep the cost of what has been passed, and once from the near side.
    /// @pre set.count() >= 2
    Place cheapest(const BoxSet<T>& set, std::size_t axis) {
        const auto& order = orders_[axis];
        Box<T>      passed;
        for (std::uint32_t i = set.end - 1; i > set.begin; --i) {
            passed.include(references_[order[i]].box);
            far_cost_[i] = T(set.end - i) * passed.half_area();
        }
        Place best{axis, set.begin + 1, std::numeric_limits<T>::infinity()};
        passed = {};
        // The cost (4.10) of each place between two neighbours.
        for (std::uint32_t i = set.begin + 1; i < set.end; ++i) {
            passed.include(references_[order[i - 1]].box);
            const T cost = cut_cost(set, T(i - set.begin) * passed.half_area(), far_cost_[i]);
            if (cost < best.cost) best = {axis, i, cost};
        }
        return best;
    }

    /// Brings the references before `middle` in one order to the front of the other two as well.
    std::uint32_t partition(const BoxSet<T>& set, std::size_t axis, std::uint32_t middle) {
        for (std::uint32_t i = set.begin; i < set.end; ++i) far_[orders_[axis][i]] = i >= middle;
        for (std::size_t other = 0; other < 3; ++other) {
            if (other == axis) continue;
            auto near = orders_[other].begin() + set.begin;
            waiting_.clear();
            for (auto i = near; i != orders_[other].begin() + set.end; ++i) {
                if (far_[*i] == 0)
                    *near++ = *i;
                else
                    waiting_.push_back(*i);
            }
            std::copy(waiting_.begin(), waiting_.end(), near);
        }
        return middle;
    }

    std::vector<BoxReference<T>>              references_;
    std::array<std::vector<std::uint32_t>, 3> orders_;    ///< of references, along each axis
    std::vector<T>                            far_cost_;  ///< of what lies from a position on
    std::vector<std::uint8_t>                 far_;       ///< whether a reference lies beyond the cut
    std::vector<std::uint32_t>                waiting_;   ///< what lies beyond, until the rest is in place
};

}  // namespace sr
