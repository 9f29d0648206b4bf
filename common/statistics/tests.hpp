#pragma once
/// @file tests.hpp
/// Is it chance? A test turns a deviation into its p-value: how often chance alone would do as much. It passes
/// if p is above a significance that was stated before.

#include <cstdint>
#include <span>

namespace sr {

/// How far an estimate lies from what is expected.
struct ZTest {
    double z;  ///< in standard errors
    double p;  ///< two-sided: erfc(|z| / sqrt(2))
};

/// @pre    estimate normally distributed: a mean of many; 0 < standard_error
/// @throws std::invalid_argument if the standard error is not positive
[[nodiscard]] ZTest z_test(double estimate, double standard_error, double expected);

/// Probability that a chi-square variable of k degrees of freedom exceeds x. With h = x / 2:
///     k even:  e^-h sum h^a / a!,             a = 0, 1, ... k/2 - 1
///     k odd:   erfc(sqrt(h)) + e^-h sum h^a / Gamma(a + 1),   a = 1/2, 3/2, ... k/2 - 1
/// All terms are positive, and none overflows as it is summed here, by logarithms.
/// @pre    0 <= x, 1 <= k
/// @throws std::invalid_argument otherwise
/// @see    Abramowitz and Stegun, 26.4.4 and 26.4.5
[[nodiscard]] double chi_square_survival(double x, int k);

/// How far counts lie from what is expected.
struct ChiSquare {
    double statistic;  ///< sum (observed - expected)^2 / expected
    int    degrees;    ///< of freedom: cells after pooling, less one
    double p;
};

/// Pearson's test of counts. Cells with the smallest expectations are pooled until the pool expects 5 or more,
/// below which the statistic isn't chi-square distributed. A count where none is expected has p = 0.
/// @param expected  not probabilities: counts, whose sum is that of the observed to 0.1 %
/// @throws std::invalid_argument if the two don't belong together, or fewer than two cells remain
[[nodiscard]] ChiSquare chi_square_test(std::span<const std::uint64_t> observed,
                                        std::span<const double>        expected);

}  // namespace sr
