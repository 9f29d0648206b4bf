#pragma once
/// @file linear.hpp

#include <cmath>
#include <concepts>

namespace sr {

/// A number in [0, 1] with the density (1 - x) a + x b, up to a factor: the smaller root of the quadratic that its
/// integral is, in the form that does not cancel.
/// @param u  uniform in [0, 1]
/// @pre      a >= 0, b >= 0, and not both are 0
/// @see      Pharr, Jakob and Humphreys, Physically Based Rendering, 4th ed. (2023), 2.3.2
template <std::floating_point T>
[[nodiscard]] T sample_linear(T u, T a, T b) {
    if (u == 0) return 0;  // 0/0 where a is 0
    return u * (a + b) / (a + std::sqrt((1 - u) * a * a + u * b * b));
}

}  // namespace sr
