#pragma once
/// @file cap_overlap.hpp

#include <algorithm>
#include <cmath>
#include <concepts>
#include <numbers>

#include "radiometry/solid_angle.hpp"

namespace sr {

/// The directions that lie within `a` of one direction and within `b` of another, `apart` from the first: how much of
/// a spherical lamp a nearer sphere hides, or, with b = pi/2, how much of it is above the horizon. Known to about
/// 10^-15 sr.
/// @param a, b   half-angles of the two caps [rad], 0 to pi/2
/// @param apart  angle between their axes [rad], 0 to pi
/// @see   Tovchigrechko & Vakser, How common is the funnel-like energy landscape in protein-protein interactions?,
///        Protein Science 10 (2001)
template <std::floating_point T>
[[nodiscard]] SolidAngle<T> cap_overlap(T a, T b, T apart) {
    if (apart >= a + b) return SolidAngle<T>{0};
    if (apart <= std::abs(a - b)) return cap_solid_angle(a < b ? a : b);
    const T    ca = std::cos(a), cb = std::cos(b), cd = std::cos(apart);
    const T    sa = std::sin(a), sb = std::sin(b), sd = std::sin(apart);
    const auto angle = [](T cosine) { return std::acos(std::clamp(cosine, T{-1}, T{1})); };
    // Girard's excess of the two sectors, less that of the triangles between the axes and where the circles meet
    const T    half = std::numbers::pi_v<T> - angle((cd - ca * cb) / (sa * sb)) -
                   ca * angle((cb - ca * cd) / (sa * sd)) - cb * angle((ca - cb * cd) / (sb * sd));
    return SolidAngle<T>{2 * half};
}

}  // namespace sr
