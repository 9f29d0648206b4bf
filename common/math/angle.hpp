#pragma once
/// @file angle.hpp

#include <cmath>
#include <concepts>

#include "math/vector.hpp"

namespace sr {

/// The angle between two unit vectors [rad], 0 to pi. The textbook's acos(a.b) loses half of the digits near 0
/// and pi, and is NaN where rounding takes a.b beyond 1. Here neighbours are subtracted, which is exact.
/// @pre |a| = |b| = 1 to rounding
/// @see Kahan, How Futile are Mindless Assessments of Roundoff in Floating-Point Computation? (2006), section 12
template <std::floating_point T>
[[nodiscard]] T angle_between(const Vector3<T>& a, const Vector3<T>& b) {
    return 2 * std::atan2(length(a - b), length(a + b));
}

}  // namespace sr
