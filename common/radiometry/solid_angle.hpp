#pragma once
/// @file solid_angle.hpp
/// How large a thing looks from the origin: the area of its image on the unit sphere [sr].

#include <cmath>
#include <concepts>
#include <numbers>

#include "geometry/sphere.hpp"
#include "math/square.hpp"
#include "math/vector.hpp"
#include "radiometry/quantity.hpp"

namespace sr {

/// [sr/m^2]
template <class V>
using SolidAnglePerArea = Quantity<Unit{.metre = -2, .steradian = 1}, V>;

/// d(omega) / dA = cos(theta) / r^2, equation (5.5): what a small area's size is multiplied by. The one place where
/// steradians come from metres.
/// @param cosine    between the area's normal and the line of sight
/// @param distance  of the area, > 0
template <std::floating_point T>
[[nodiscard]] constexpr SolidAnglePerArea<T> solid_angle_per_area(T cosine, Length<T> distance) {
    return SolidAnglePerArea<T>{cosine / square(distance.value())};
}

/// The directions within `half_angle` [rad] of one, 0 to pi: 2 pi (1 - cos a) = 4 pi sin^2(a/2), which has all its
/// digits where a is small.
template <std::floating_point T>
[[nodiscard]] SolidAngle<T> cap_solid_angle(T half_angle) {
    return SolidAngle<T>{4 * std::numbers::pi_v<T> * square(std::sin(half_angle / 2))};
}

/// A sphere's, equation (5.7): 2 pi s^2 / (1 + sqrt(1 - s^2)) with s = r/d, and all of 4 pi from inside. The
/// textbook's 2 pi (1 - cos) is 0 in float from 5000 radii on.
/// @pre radius > 0
template <std::floating_point T>
[[nodiscard]] SolidAngle<T> solid_angle(const Sphere<T>& sphere) {
    const T r = sphere.radius;
    const T d = length(sphere.centre);
    if (d < r) return SolidAngle<T>{4 * std::numbers::pi_v<T>};
    // 1 - cos = s^2 / (1 + cos), which does not cancel
    const T cosine = std::sqrt((d - r) * (d + r)) / d;
    return SolidAngle<T>{2 * std::numbers::pi_v<T> * square(r / d) / (1 + cosine)};
}

/// The rectangle of sides 2a and 2b, seen from above its centre at the height h >= 0.
/// @see Khadjavi, Calculation of Solid Angle Subtended by Rectangular Apertures, J. Opt. Soc. Am. 58 (1968)
template <std::floating_point T>
[[nodiscard]] SolidAngle<T> centred_rectangle_solid_angle(T a, T b, T h) {
    return SolidAngle<T>{4 * std::atan2(a * b, h * std::hypot(a, b, h))};
}

}  // namespace sr
