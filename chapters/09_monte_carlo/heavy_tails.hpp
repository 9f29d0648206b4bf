#pragma once
/// @file heavy_tails.hpp
/// Section 9.10: integrands whose square has no integral. They are drawn uniformly, and clamped if that is asked for.

#include <algorithm>
#include <cmath>
#include <limits>

#include "math/square.hpp"
#include "sampling/rng.hpp"

namespace sr {

inline constexpr double unclamped = std::numeric_limits<double>::infinity();

/// 1 / sqrt(x) over [0, 1]: the integral is 2.
[[nodiscard]] inline double draw_root(double clamp, Rng& rng) {
    return std::min(1 / std::sqrt(1 - rng.uniform<double>()), clamp);
}

/// 1 / r^2 at a point of the unit ball, as a point lights the fog around it: the mean is 3.
[[nodiscard]] inline double draw_in_ball(double clamp, Rng& rng) {
    return std::min(1 / square(std::cbrt(1 - rng.uniform<double>())), clamp);
}

/// Mean and variance of a draw that is clamped, in closed form.
struct Clamped {
    double mean, variance;
};

/// @param clamp  1 or more
[[nodiscard]] inline Clamped clamped_root(double clamp) {
    const double mean = 2 - 1 / clamp;
    return {mean, 1 + 2 * std::log(clamp) - square(mean)};
}

[[nodiscard]] inline Clamped clamped_in_ball(double clamp) {
    const double mean = 3 - 2 / std::sqrt(clamp);
    return {mean, 4 * std::sqrt(clamp) - 3 - square(mean)};
}

}  // namespace sr
