#pragma once
/// @file concentric_disk.hpp
/// Points of a disk about the origin, each as likely, by a map that keeps neighbours together: squares about the middle
/// of the unit square become circles. Strata stay compact, where the polar map of disk.hpp draws them out to thin
/// sectors, and nothing is cut open along an axis. The density is that of disk.hpp: `pdf_disk`.
/// @see Shirley and Chiu, A Low Distortion Map Between Disk and Square, Journal of Graphics Tools 2 (1997)

#include <cmath>
#include <concepts>
#include <numbers>

#include "math/vector.hpp"
#include "sampling/disk.hpp"

namespace sr {

/// The larger of |a| and |b|, with a and b from -1 to 1, is the radius; the smaller one's share of it is the angle from
/// the larger one's axis, as a share of 45 degrees.
/// @pre 0 <= u.x < 1 and 0 <= u.y < 1; radius > 0
template <std::floating_point T>
[[nodiscard]] Vector2<T> sample_concentric_disk(Vector2<T> u, T radius) {
    constexpr T eighth = std::numbers::pi_v<T> / 4;  // of a turn

    const T    a = 2 * u.x - 1, b = 2 * u.y - 1;
    const bool along_x = std::abs(a) > std::abs(b);
    const T    r       = along_x ? a : b;
    if (r == 0) return {0, 0};  // where the share would be 0/0
    const T phi   = eighth * ((along_x ? b : a) / r);
    const T along = radius * r * std::cos(phi), aside = radius * r * std::sin(phi);
    return along_x ? Vector2<T>{along, aside} : Vector2<T>{aside, along};
}

template <std::floating_point T>
[[nodiscard]] Vector2<T> invert_concentric_disk(const Vector2<T>& p, T radius) {
    constexpr T eighth = std::numbers::pi_v<T> / 4;

    const bool along_x = std::abs(p.x) > std::abs(p.y);
    const T    along = along_x ? p.x : p.y, aside = along_x ? p.y : p.x;
    if (along == 0) return {T(0.5), T(0.5)};
    const T r       = std::copysign(length(p), along) / radius;
    const T smaller = r * (std::atan(aside / along) / eighth);
    return along_x ? Vector2<T>{(r + 1) / 2, (smaller + 1) / 2} : Vector2<T>{(smaller + 1) / 2, (r + 1) / 2};
}

}  // namespace sr
