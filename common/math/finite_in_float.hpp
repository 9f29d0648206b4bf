#pragma once
/// @file finite_in_float.hpp

#include <cmath>
#include <limits>

#include "math/vector.hpp"

namespace sr {

/// Whether a number that is rendered in float is finite there, too: 1e300 is not, and NaN never.
[[nodiscard]] inline bool finite_in_float(double x) {
    return std::abs(x) <= double(std::numeric_limits<float>::max());
}

[[nodiscard]] inline bool finite_in_float(const Vector3<double>& v) {
    return finite_in_float(v.x) && finite_in_float(v.y) && finite_in_float(v.z);
}

}  // namespace sr
