#pragma once
/// @file strata.hpp
/// Section 9.9: the integral of x^5 over [0, 1] in 16 strata, some of which need more samples than others.

#include <cmath>
#include <cstddef>
#include <vector>

#include "allocation.hpp"
#include "math/square.hpp"
#include "sampling/rng.hpp"
#include "statistics/running.hpp"

namespace sr {

inline constexpr int strata = 16;

/// A number of the stratum, and what it counts there.
[[nodiscard]] inline double draw_in_stratum(int stratum, Rng& rng) {
    const double x = (stratum + rng.uniform<double>()) / strata;
    return square(square(x)) * x;
}

/// The standard deviation in each stratum, in closed form.
[[nodiscard]] inline std::vector<double> deviations_in_strata() {
    std::vector<double> all;
    for (int i = 0; i < strata; ++i) {
        const double a = double(i) / strata, b = double(i + 1) / strata;
        const double mean   = strata * (std::pow(b, 6) - std::pow(a, 6)) / 6;
        const double second = strata * (std::pow(b, 11) - std::pow(a, 11)) / 11;
        all.push_back(std::sqrt(second - square(mean)));
    }
    return all;
}

/// The variance of the mean over all strata: the sum of sigma_i^2 / n_i, over the number of strata squared.
/// @pre as many counts as strata, all above 0
[[nodiscard]] inline double variance_in_strata(const std::vector<int>& counts) {
    const auto deviations = deviations_in_strata();
    double     sum        = 0;
    for (std::size_t i = 0; i < counts.size(); ++i) sum += square(deviations[i]) / counts[i];
    return sum / square(double(strata));
}

/// The mean over all strata, so many samples in each.
[[nodiscard]] inline double estimate_in_strata(const std::vector<int>& counts, Rng& rng) {
    double sum = 0;
    for (int i = 0; i < strata; ++i) {
        Running in_stratum;
        for (int k = 0; k < counts[std::size_t(i)]; ++k) in_stratum.add(draw_in_stratum(i, rng));
        sum += in_stratum.mean();
    }
    return sum / strata;
}

/// As many samples as `total` in two passes: a pilot of so many in each stratum decides where the others go, and is
/// then forgotten.
[[nodiscard]] inline double estimate_in_two_passes(int pilot, int total, Rng& rng) {
    std::vector<double> deviations;
    for (int i = 0; i < strata; ++i) {
        Running in_stratum;
        for (int k = 0; k < pilot; ++k) in_stratum.add(draw_in_stratum(i, rng));
        deviations.push_back(std::sqrt(in_stratum.variance()));
    }
    return estimate_in_strata(allocated(deviations, total - pilot * strata, 1), rng);
}

}  // namespace sr
