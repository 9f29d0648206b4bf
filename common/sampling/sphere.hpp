#pragma once
/// @file sphere.hpp
/// Directions of the whole sphere, each as likely, in the triple sample, pdf, invert.

#include <cmath>
#include <concepts>
#include <numbers>

#include "math/vector.hpp"
#include "sampling/hemisphere.hpp"
#include "sampling/pdf.hpp"

namespace sr {

/// z = 1 - 2 u.x is uniform (Archimedes' hat box), phi = 2 pi u.y. The distance from the axis, sqrt(1 - z^2), is taken
/// of u.x itself: near the poles 1 - z^2 would cancel.
/// @pre    0 <= u.x < 1 and 0 <= u.y < 1
/// @return unit length to rounding
template <std::floating_point T>
[[nodiscard]] Vector3<T> sample_uniform_sphere(Vector2<T> u) {
    const T r   = 2 * std::sqrt(u.x * (1 - u.x));
    const T phi = 2 * std::numbers::pi_v<T> * u.y;
    return {r * std::cos(phi), r * std::sin(phi), 1 - 2 * u.x};
}

/// 1 / 4 pi, whatever the direction.
template <std::floating_point T>
[[nodiscard]] Pdf<measure::SolidAngle> pdf_uniform_sphere(const Vector3<T>& /*w*/) {
    return {1 / (4 * std::numbers::pi)};
}

template <std::floating_point T>
[[nodiscard]] Vector2<T> invert_uniform_sphere(const Vector3<T>& w) {
    return {(1 - w.z) / 2, turn(w)};
}

}  // namespace sr
