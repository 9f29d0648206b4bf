#pragma once
/// @file ray.hpp

#include <concepts>

#include "math/vector.hpp"

namespace sr {

/// The half-line r(t) = o + t d, t >= 0, equation (1.1). The direction has any length but zero; t counts in
/// units of |d|.
template <std::floating_point T>
struct Ray {
    Vector3<T> origin;
    Vector3<T> direction;

    [[nodiscard]] constexpr Vector3<T> at(T t) const { return origin + t * direction; }
};

}  // namespace sr
