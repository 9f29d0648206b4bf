#pragma once
/// @file allocation.hpp
/// How samples are shared out.

#include <cmath>
#include <span>
#include <stdexcept>
#include <vector>

namespace sr {

/// Numbers of samples in proportion to the weights, equation (9.26), above a least that each gets. They add up to
/// `total` exactly: each ends where the rounded sum of all up to it does.
/// @param weights  not negative, and not all 0
/// @throws std::invalid_argument if the total does not suffice for the least, or no weight is positive
[[nodiscard]] inline std::vector<int> allocated(std::span<const double> weights, int total, int least) {
    double sum = 0;
    for (const double weight : weights) sum += weight;
    const double free = double(total) - double(least) * double(weights.size());
    if (!(sum > 0 && free >= 0))
        throw std::invalid_argument("too few samples to share out, or nothing to share them by");
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
