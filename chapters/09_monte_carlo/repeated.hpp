#pragma once
/// @file repeated.hpp
/// An estimate is repeated with other random numbers, and its errors are counted.

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "statistics/estimate.hpp"
#include "statistics/running.hpp"
#include "transport/tiles.hpp"

namespace sr {

/// What repeats 0, 1, ... give, in this order. The same to the bit for any number of threads.
/// @param once  (std::uint64_t repeat) -> a value; called from several threads
template <class Once>
[[nodiscard]] auto repeated(int repeats, int threads, const Once& once) {
    std::vector<decltype(once(std::uint64_t{0}))> values(static_cast<std::size_t>(repeats));
    for_each_pixel(repeats, 1, {.threads = threads},
                   [&](int x, int) { values[std::size_t(x)] = once(std::uint64_t(x)); });
    return values;
}

/// The squared errors of the repeats of an estimate: their mean is the variance, if the estimate is right on average.
/// @param once  as above, -> an estimate of `truth`
template <class Once>
[[nodiscard]] Running squared_errors(int repeats, int threads, double truth, const Once& once) {
    Running mean;
    for (const double value : repeated(repeats, threads, once)) mean.add((value - truth) * (value - truth));
    return mean;
}

[[nodiscard]] inline Estimate mean_square(const Running& squares) {
    return {squares.mean(), squares.standard_error()};
}

/// The root of the mean square. Its standard error is that of the mean, divided by twice the root: d sqrt(m) = dm / (2
/// sqrt(m)).
[[nodiscard]] inline Estimate root_mean_square(const Running& squares) {
    const double root = std::sqrt(squares.mean());
    return {root, root > 0 ? squares.standard_error() / (2 * root) : 0};
}

}  // namespace sr
