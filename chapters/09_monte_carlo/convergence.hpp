#pragma once
/// @file convergence.hpp
/// Section 9.7: how the errors of patterns fall with the number of samples.

#include <cmath>
#include <cstdint>
#include <functional>
#include <numbers>
#include <stdexcept>
#include <string>
#include <vector>

#include "course/chapter.hpp"
#include "pattern_mean.hpp"
#include "repeated.hpp"
#include "sampling/halton_point.hpp"
#include "sampling/random_point.hpp"
#include "sampling/sobol_point.hpp"
#include "sampling/stratified_point.hpp"
#include "statistics/slope.hpp"

namespace sr {

/// One pattern at one number of samples, and the error of the means over 256 seeds.
struct PatternLap {
    std::string                          method;
    std::uint32_t                        n;
    std::function<double(std::uint64_t)> once;  ///< the mean, by its seed
    Estimate                             error;
};

/// A bump, e^(-x^2 - y^2): no edge anywhere.
struct Bump {
    static double integral() {
        const double side = std::sqrt(std::numbers::pi) / 2 * std::erf(1.0);
        return side * side;
    }
    double operator()(Vector2<double> u) const { return std::exp(-u.x * u.x - u.y * u.y); }
};

/// 1 below an oblique line, 0 above it, as the border of something is in a pixel. Its slope is not that of any line
/// through points of a grid.
struct HalfPlane {
    static constexpr double slope = 1 / std::numbers::phi, start = 0.3;

    static double integral() { return start + slope / 2; }
    double        operator()(Vector2<double> u) const { return u.y < start + slope * u.x ? 1 : 0; }
};

/// What is measured: powers of 2 from 2^4 on. Slopes are those up to 2^14, at any quality.
struct SampleRange {
    int last;  ///< exponent
    int threads;
};
inline constexpr int last_fitted = 14;

/// All n of one pattern; strata of squares need n = 4^k.
template <SamplePoint P, class F>
void add_pattern(std::vector<PatternLap>& laps, const std::string& method, int curve, int step,
                 const SampleRange& range, const F& f) {
    for (int k = 4; k <= range.last; k += step) {
        const std::uint32_t n = 1U << k;
        const auto    once = [=](std::uint64_t seed) { return pattern_mean<P>(curve, seed, n, of_pair(f)); };
        const Running squares = squared_errors(256, range.threads, F::integral(), once);
        laps.push_back({method, n, once, root_mean_square(squares)});
    }
}

/// The four patterns.
/// @param curve  number of the first
template <class F>
[[nodiscard]] std::vector<PatternLap> run_patterns(int curve, const SampleRange& range, const F& f) {
    std::vector<PatternLap> laps;
    add_pattern<RandomPoint>(laps, "random", curve, 1, range, f);
    add_pattern<StratifiedPoint>(laps, "jittered", curve + 1, 2, range, f);
    add_pattern<HaltonPoint>(laps, "Halton, moved", curve + 2, 1, range, f);
    add_pattern<SobolPoint>(laps, "Sobol', scrambled", curve + 3, 1, range, f);
    return laps;
}

/// The power of n with which the error of a pattern changes.
[[nodiscard]] inline Slope slope_of(const std::vector<PatternLap>& laps, const std::string& method) {
    std::vector<double>   n;
    std::vector<Estimate> errors;
    for (const auto& lap : laps) {
        if (lap.method != method || lap.n > 1U << last_fitted) continue;
        n.push_back(lap.n);
        errors.push_back(lap.error);
    }
    return log_log_slope(n, errors);
}

/// The error of a pattern at n.
[[nodiscard]] inline Estimate error_of(const std::vector<PatternLap>& laps, const std::string& method,
                                       std::uint32_t n) {
    for (const auto& lap : laps)
        if (lap.method == method && lap.n == n) return lap.error;
    throw std::out_of_range("no lap of " + method);
}

}  // namespace sr
