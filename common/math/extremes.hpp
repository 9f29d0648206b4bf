#pragma once
/// @file extremes.hpp
/// The larger and the smaller of two numbers where a NaN must not get lost: std::max, std::min, std::fmax and
/// std::fmin each hide it in one operand at least, and the worst error of all would be none.

#include <cmath>
#include <concepts>

namespace sr {

/// The larger one; NaN if one of them is NaN.
template <std::floating_point T>
[[nodiscard]] T max_or_nan(T a, T b) {
    return a > b || std::isnan(a) ? a : b;
}

/// The smaller one; NaN if one of them is NaN.
template <std::floating_point T>
[[nodiscard]] T min_or_nan(T a, T b) {
    return a < b || std::isnan(a) ? a : b;
}

}  // namespace sr
