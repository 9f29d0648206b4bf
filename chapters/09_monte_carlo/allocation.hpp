#pragma once
/// @file allocation.hpp
/// How samples are shared out.

#include <fmt/format.h>

#include <cmath>
#include <span>
#include <stdexcept>
#include <vector>

namespace sr {

/// Numbers of samples in proportion to the weights, equation (9.26), above a least that each gets. They add up to
/// `total` exactly: each ends where the rounded sum of all up to it does.
/// @param weights  not negative, and not all 0
/// @throws std::invalid_argument if the total does not suffice for the least, or the weights' sum is 0 or not finite
[[nodiscard]] inline std::vector<int> allocated(std::span<const double> weights, int total, int least) {
    double sum = 0;
    for (const double weight : weights) sum += weight;
    const double free = double(total) - double(least) * double(weights.size());
    if (!(sum > 0 && std::isfinite(sum)))
        throw std::invalid_argument(
            fmt::format("the weights to share samples out by sum to {}; must be above 0, and finite", sum));
    if (!(free >= 0))
        throw std::invalid_argument(fmt::format(
            "{} samples for {} that get {} each; must be no fewer than that", total, weights.size(), least));
    std::vector<int> counts;
    double           before = 0;
    for (const double weight : weights) {
        const double up_to = before + weight;
        counts.push_back(least + int(std::lround(free * up_to / sum) - std::lround(free * before / sum)));
        before = up_to;
    }
    return counts;
}

}  // namespace sr
