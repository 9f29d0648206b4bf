#pragma once
/// @file estimate.hpp
/// What is counted or measured of random samples, with its standard error.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace sr {

/// A number that is known from random samples, and one standard error of it.
struct Estimate {
    double value = 0;
    double error = 0;
};

/// The share of n samples that `count` of them are. Its error is that of (count + 1) / (n + 2), Laplace's estimate:
/// that nothing was seen in n samples does not say that there is nothing.
/// @pre 0 <= count <= n, 0 < n
[[nodiscard]] inline Estimate share(int count, std::size_t n) {
    const double p = (count + 1) / (double(n) + 2);
    return {count / double(n), std::sqrt(p * (1 - p) / double(n))};
}

[[nodiscard]] inline Estimate percent(Estimate share) {
    return {100 * share.value, 100 * share.error};
}

/// The median, and half the distance of the two values that lie as many ranks above and below it as the number of
/// values under the median varies by: sqrt(n) / 2.
/// @pre values is not empty
[[nodiscard]] inline Estimate median(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    const double n  = double(values.size());
    const auto   at = [&](double rank) { return values[std::size_t(std::clamp(rank, 0.0, n - 1))]; };
    return {at(n / 2), (at(n / 2 + std::sqrt(n) / 2) - at(n / 2 - std::sqrt(n) / 2)) / 2};
}

}  // namespace sr
