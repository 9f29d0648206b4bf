#pragma once
/// @file cone.hpp
/// Directions in a cone about +z, each as likely, in the triple sample, pdf, invert. The cone is given by the sine s of
/// its half-angle, at most a right one, and never by its cosine: that of a small lamp is 1 in float, and all samples
/// would be its centre. What is drawn is the height h = 1 - cos instead.

#include <cmath>
#include <concepts>
#include <limits>
#include <numbers>

#include "math/square.hpp"
#include "math/vector.hpp"
#include "sampling/hemisphere.hpp"
#include "sampling/pdf.hpp"

namespace sr {

/// 1 - cos of the half-angle, which does not cancel so: s^2 / (1 + sqrt(1 - s^2)).
/// @pre 0 <= s <= 1
template <std::floating_point T>
[[nodiscard]] T cone_height(T s) {
    return square(s) / (1 + std::sqrt((1 - s) * (1 + s)));
}

/// A direction in the cone: h is uniform (Archimedes' hat box), h = u.x (1 - cos a); phi = 2 pi u.y.
/// @pre    0 <= u.x < 1 and 0 <= u.y < 1; 0 < s <= 1
/// @return unit length to rounding
template <std::floating_point T>
[[nodiscard]] Vector3<T> sample_cone(Vector2<T> u, T s) {
    const T h   = u.x * cone_height(s);
    const T r   = std::sqrt(h * (2 - h));
    const T phi = 2 * std::numbers::pi_v<T> * u.y;
    return {r * std::cos(phi), r * std::sin(phi), 1 - h};
}

/// 1 / (2 pi (1 - cos a)), and 0 outside of the cone.
template <std::floating_point T>
[[nodiscard]] Pdf<measure::SolidAngle> pdf_cone(const Vector3<T>& w, T s) {
    constexpr T rounding = 1 + 8 * std::numeric_limits<T>::epsilon();  // the rim belongs to the cone
    const bool  inside   = w.z >= 0 && square(w.x) + square(w.y) <= rounding * square(s);
    return {inside ? 1 / (2 * std::numbers::pi * cone_height(double(s))) : 0};
}

template <std::floating_point T>
[[nodiscard]] Vector2<T> invert_cone(const Vector3<T>& w, T s) {
    const T h = (square(w.x) + square(w.y)) / (1 + w.z);
    return {h / cone_height(s), turn(w)};
}

}  // namespace sr
