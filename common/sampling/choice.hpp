#pragma once
/// @file choice.hpp
/// One of several, drawn, each as often as its share of a sum.
///
///     if (const auto one = choose(lamps, power_of, u.x)) follow(lamps[one->index], {one->u, u.y});

#include <algorithm>
#include <concepts>
#include <cstddef>
#include <optional>
#include <ranges>

#include "sampling/unit_interval.hpp"

namespace sr {

template <std::floating_point T>
struct Choice {
    std::size_t index;
    T           chance;  ///< with which it is drawn, its weight's share of the sum of all
    T           u;       ///< what is left of the number that chose, uniform in [0, 1) again
};

/// None if no weight is more than 0.
/// @param weight  (one of the items) -> T, at least 0 and finite
/// @param u       uniform in [0, 1)
template <std::ranges::forward_range Items, class Weight, std::floating_point T>
[[nodiscard]] std::optional<Choice<T>> choose(const Items& items, const Weight& weight, T u) {
    T sum = 0;
    for (const auto& item : items) sum += weight(item);
    std::optional<Choice<T>> chosen;
    std::size_t              index = 0;
    for (const auto& item : items) {
        const T chance = weight(item) / sum;
        if (chance > 0) {
            chosen = {index, chance, std::min(u / chance, largest_below_1<T>)};
            if (u < chance) break;
            u -= chance;  // if this was the last one, rounding has left a little more: it is taken
        }
        ++index;
    }
    return chosen;
}

}  // namespace sr
