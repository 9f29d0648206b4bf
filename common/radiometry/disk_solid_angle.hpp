#pragma once
/// @file disk_solid_angle.hpp

#include <cmath>
#include <concepts>
#include <numbers>

#include "geometry/disk.hpp"
#include "math/elliptic.hpp"
#include "math/square.hpp"
#include "radiometry/quantity.hpp"

namespace sr {

/// A disk's solid angle from a point on its axis, 2 pi (1 - h / D) = 2 pi R^2 / (D (D + h)) with D^2 = R^2 + h^2: the
/// second form does not cancel.
/// @pre radius > 0, height >= 0
template <std::floating_point T>
[[nodiscard]] SolidAngle<T> disk_on_axis_solid_angle(T radius, T height) {
    const T D = std::hypot(radius, height);
    return SolidAngle<T>{2 * std::numbers::pi_v<T> * square(radius) / (D * (D + height))};
}

/// A disk's solid angle from the origin, wherever that is. Off the axis it is elliptic, and known to about 10^-15 sr:
/// of one that looks small, fewer digits.
/// @see Paxton, Solid Angle Calculation for a Circular Disk, Rev. Sci. Instrum. 30 (1959)
template <std::floating_point T>
[[nodiscard]] SolidAngle<T> solid_angle(const Disk<T>& disk) {
    const auto   centre = Vector3<double>(disk.centre);
    const auto   normal = Vector3<double>(disk.normal);
    const double R      = double(disk.radius);
    const double h      = std::abs(dot(centre, normal));
    const double a      = length(cross(centre, normal));  // from the axis
    if (a == 0) return disk_on_axis_solid_angle(disk.radius, T(h));
    if (h == 0) return SolidAngle<T>{a < R ? 2 * std::numbers::pi_v<T> : T{0}};
    const double farthest   = std::hypot(h, a + R);
    const double complement = square(std::hypot(h, a - R) / farthest);  // 1 - k^2
    const double q          = (R - a) / (R + a);
    const double K          = elliptic_k(complement);
    const double q_pi       = square(q) > 0 ? q * elliptic_pi(square(q), complement) : 0;
    const double below      = a < R ? 2 * std::numbers::pi : a > R ? 0 : std::numbers::pi;
    return SolidAngle<T>{T(below - 2 * h / farthest * (K + q_pi))};
}

}  // namespace sr
