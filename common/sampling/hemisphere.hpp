#pragma once
/// @file hemisphere.hpp
/// Directions above a surface whose normal is +z, drawn in two ways. Each is a triple: `sample` maps the unit
/// square [0, 1)^2 to directions, `pdf` is the density with which they come, `invert` undoes the map.

#include <cmath>
#include <concepts>
#include <limits>
#include <numbers>

#include "math/vector.hpp"
#include "sampling/pdf.hpp"

namespace sr {

/// The share of a whole turn about +z at which w lies, from +x towards +y: in [0, 1).
template <std::floating_point T>
[[nodiscard]] T turn(const Vector3<T>& w) {
    const T share = std::atan2(w.y, w.x) / (2 * std::numbers::pi_v<T>);
    return share < 0 ? share + 1 - std::numeric_limits<T>::epsilon() / 2 : share;
}

/// A direction with pdf(w) = cos(theta) / pi: uniform in the unit disk, by polar coordinates r = sqrt(u.x),
/// phi = 2 pi u.y, then lifted to the sphere (Malley's method).
/// @pre    0 <= u.x < 1 and 0 <= u.y < 1; so z >= 2^-12 in float, and dividing by the pdf is safe
/// @return unit length to rounding
template <std::floating_point T>
[[nodiscard]] Vector3<T> sample_cosine_hemisphere(Vector2<T> u) {
    const T r   = std::sqrt(u.x);
    const T phi = 2 * std::numbers::pi_v<T> * u.y;
    return {r * std::cos(phi), r * std::sin(phi), std::sqrt(1 - u.x)};
}

/// cos(theta) / pi, and 0 below the horizon.
template <std::floating_point T>
[[nodiscard]] Pdf<measure::SolidAngle> pdf_cosine_hemisphere(const Vector3<T>& w) {
    return {w.z > 0 ? double(w.z) / std::numbers::pi : 0};
}

template <std::floating_point T>
[[nodiscard]] Vector2<T> invert_cosine_hemisphere(const Vector3<T>& w) {
    return {w.x * w.x + w.y * w.y, turn(w)};
}

/// A direction with pdf(w) = 1 / 2 pi: z = 1 - u.x is uniform (Archimedes' hat box), phi = 2 pi u.y.
/// @pre    0 <= u.x < 1 and 0 <= u.y < 1; so z > 0
/// @return unit length to rounding
template <std::floating_point T>
[[nodiscard]] Vector3<T> sample_uniform_hemisphere(Vector2<T> u) {
    const T z   = 1 - u.x;
    const T r   = std::sqrt(u.x * (1 + z));
    const T phi = 2 * std::numbers::pi_v<T> * u.y;
    return {r * std::cos(phi), r * std::sin(phi), z};
}

/// 1 / 2 pi, and 0 below the horizon.
template <std::floating_point T>
[[nodiscard]] Pdf<measure::SolidAngle> pdf_uniform_hemisphere(const Vector3<T>& w) {
    return {w.z > 0 ? 1 / (2 * std::numbers::pi) : 0};
}

template <std::floating_point T>
[[nodiscard]] Vector2<T> invert_uniform_hemisphere(const Vector3<T>& w) {
    return {1 - w.z, turn(w)};
}

}  // namespace sr
