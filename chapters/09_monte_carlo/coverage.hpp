#pragma once
/// @file coverage.hpp
/// Is an error what its estimate says?

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "estimator.hpp"
#include "first_integral.hpp"
#include "repeated.hpp"
#include "statistics/estimate.hpp"

namespace sr {

/// The shares [%] of the repeats whose error is at most one, two and three of the standard errors that they state
/// themselves.
/// @param n  samples of each
[[nodiscard]] inline std::array<Estimate, 3> coverage(int n, int repeats, int threads) {
    const auto         errors = repeated(repeats, threads, [=](std::uint64_t k) {
        Rng           rng{92, std::int64_t(k), n, 0};
        const Running mean = monte_carlo(rng, growth, EvenDensity{}, n);
        return std::abs(mean.mean() - growth_integral()) / mean.standard_error();
    });
    std::array<int, 3> within{};
    for (const double error : errors) {
        for (std::size_t i = 0; i < 3; ++i) within[i] += error <= double(i + 1) ? 1 : 0;
    }
    const auto in_percent = [&](int count) { return percent(share(count, errors.size())); };
    return {in_percent(within[0]), in_percent(within[1]), in_percent(within[2])};
}

/// Root of the mean squared error of so many repeats, and its standard error.
template <class Density>
[[nodiscard]] Estimate growth_error(const Density& p, int n, int repeats, int threads) {
    return root_mean_square(squared_errors(repeats, threads, growth_integral(), [=](std::uint64_t k) {
        Rng rng{93, std::int64_t(k), n, 0};
        return monte_carlo(rng, growth, p, n).mean();
    }));
}

}  // namespace sr
