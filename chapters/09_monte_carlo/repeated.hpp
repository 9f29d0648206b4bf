#pragma once
/// @file repeated.hpp
/// An estimate is repeated with other random numbers, and its errors are counted.

#include <cmath>
#include <cstdint>
#include <vector>

#include "statistics/estimate.hpp"
#include "statistics/running.hpp"
#include "transport/tiles.hpp"

namespace sr {

/// The squared errors of repeats 0, 1, ... of an estimate: their mean is the variance, if the estimate is right on
/// average. The same to the bit for any number of threads.
/// @param once  (std::uint64_t repeat) -> an estimate of `truth`; called from several threads
template <class Once>
[[nodiscard]] Running squared_errors(int repeats, int threads, double truth, const Once& once) {
    std::vector<double> squares(std::size_t(repeats), 0.0);
    for_each_pixel(repeats, 1, {.threads = threads}, [&](int x, int) {
        const double off        = once(std::uint64_t(x)) - truth;
        squares[std::size_t(x)] = off * off;
    });
    Running mean;
    for (const double square : squares) mean.add(square);
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
