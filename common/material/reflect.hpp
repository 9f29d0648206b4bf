#pragma once
/// @file reflect.hpp

#include <cmath>
#include <concepts>
#include <optional>

#include "math/vector.hpp"

namespace sr {

/// The mirror image of w about the normal +z: 2 (n.w) n - w.
template <std::floating_point T>
[[nodiscard]] constexpr Vector3<T> reflect(const Vector3<T>& w) {
    return {-w.x, -w.y, w.z};
}

/// The direction in which light that is seen along w goes on behind the surface z = 0, by Snell's law
/// sin(theta_i) = eta sin(theta_t); none if it is reflected totally, sin(theta_i) >= eta.
/// @param w    unit vector that leaves the surface, on either side
/// @param eta  index of refraction on the other side over that on w's side, > 0
/// @return a unit vector to rounding, on the other side of the surface
template <std::floating_point T>
[[nodiscard]] std::optional<Vector3<T>> refract(const Vector3<T>& w, T eta) {
    const T sin_i   = std::hypot(w.x, w.y);
    const T squared = (eta - sin_i) * (eta + sin_i);  // eta^2 cos^2(theta_t), asked before the root is drawn
    if (!(squared > 0)) return std::nullopt;
    return Vector3<T>{-w.x / eta, -w.y / eta, std::copysign(std::sqrt(squared) / eta, -w.z)};
}

}  // namespace sr
