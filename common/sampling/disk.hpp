#pragma once
/// @file disk.hpp
/// Points of a disk about the origin, each as likely, in the triple sample, pdf, invert.

#include <cmath>
#include <concepts>
#include <limits>
#include <numbers>

#include "math/square.hpp"
#include "math/vector.hpp"
#include "sampling/hemisphere.hpp"
#include "sampling/pdf.hpp"

namespace sr {

/// A point by polar coordinates: r = R sqrt(u.x), because the area within r grows as r^2; phi = 2 pi u.y.
/// @pre 0 <= u.x < 1 and 0 <= u.y < 1; radius > 0
template <std::floating_point T>
[[nodiscard]] Vector2<T> sample_disk(Vector2<T> u, T radius) {
    const T r   = radius * std::sqrt(u.x);
    const T phi = 2 * std::numbers::pi_v<T> * u.y;
    return {r * std::cos(phi), r * std::sin(phi)};
}

/// 1 / (pi R^2), and 0 outside.
template <std::floating_point T>
[[nodiscard]] Pdf<measure::Area> pdf_disk(const Vector2<T>& p, T radius) {
    constexpr T rounding = 1 + 8 * std::numeric_limits<T>::epsilon();  // the rim belongs to the disk
    return {dot(p, p) <= rounding * square(radius) ? 1 / (std::numbers::pi * square(double(radius))) : 0};
}

template <std::floating_point T>
[[nodiscard]] Vector2<T> invert_disk(const Vector2<T>& p, T radius) {
    return {dot(p, p) / square(radius), turn(Vector3<T>{p.x, p.y, 0})};
}

}  // namespace sr
