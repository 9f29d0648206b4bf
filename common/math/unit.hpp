#pragma once
/// @file unit.hpp

#include <algorithm>
#include <cmath>
#include <concepts>
#include <optional>

#include "math/vector.hpp"

namespace sr {

/// v / |v|, for v of any size; nothing where v is 0 or not finite, and has no direction. The plain quotient
/// squares the components, which is 0 below 10^-23 in float and infinity above 10^19.
template <std::floating_point T>
[[nodiscard]] std::optional<Vector3<T>> unit(const Vector3<T>& v) {
    const T largest = std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
    if (largest == 0 || !std::isfinite(v.x) || !std::isfinite(v.y) || !std::isfinite(v.z))
        return std::nullopt;
    int exponent = 0;
    std::frexp(largest, &exponent);
    const auto scaled = [&](T x) { return std::ldexp(x, -exponent); };  // by a power of two: no digit changes
    return normalize(Vector3<T>{scaled(v.x), scaled(v.y), scaled(v.z)});
}

}  // namespace sr
