#pragma once
/// @file linear.hpp
/// Numbers in [0, 1] whose density is linear, (1 - x) a + x b up to a factor, in the triple sample, pdf, invert.

#include <cmath>
#include <concepts>

namespace sr {

/// The smaller root of the quadratic that the density's integral is, in the form that does not cancel.
/// @param u  uniform in [0, 1]
/// @pre      a >= 0, b >= 0, and not both are 0
/// @see      Pharr, Jakob and Humphreys, Physically Based Rendering, 4th ed. (2023), 2.3.2
template <std::floating_point T>
[[nodiscard]] T sample_linear(T u, T a, T b) {
    if (u == 0) return 0;  // 0/0 where a is 0
    return u * (a + b) / (a + std::sqrt((1 - u) * a * a + u * b * b));
}

/// The density [1], and 0 outside.
/// @pre a >= 0, b >= 0, and not both are 0
template <std::floating_point T>
[[nodiscard]] double pdf_linear(T x, T a, T b) {
    return x >= 0 && x <= 1 ? 2 * ((1 - double(x)) * a + double(x) * b) / (double(a) + b) : 0;
}

/// @pre 0 <= x <= 1; a >= 0, b >= 0, and not both are 0
template <std::floating_point T>
[[nodiscard]] T invert_linear(T x, T a, T b) {
    return x * ((2 - x) * a + x * b) / (a + b);
}

}  // namespace sr
