#pragma once
/// @file projected_solid_angle.hpp
/// The integral of cos(theta) over the directions in which a thing is seen [sr]. What shines with the radiance L
/// everywhere and into all directions gives the receiver the irradiance E = L times it, equation (5.15). The receiver
/// lies in the origin with normal +z, and what is below its horizon does not count.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <concepts>
#include <limits>
#include <numbers>
#include <optional>
#include <span>
#include <stdexcept>
#include <vector>

#include "geometry/disk.hpp"
#include "geometry/sphere.hpp"
#include "math/square.hpp"
#include "math/vector.hpp"
#include "radiometry/horizon.hpp"
#include "radiometry/quantity.hpp"

namespace sr {

/// A sphere's, equations (5.16) and (5.17): pi s^2 cos(beta) while all of it is above the horizon, with s = r/d and
/// beta between its centre and the normal; else less.
/// @pre  radius > 0; from inside, the whole hemisphere: pi
/// @see  Lagarde and de Rousiers, Moving Frostbite to Physically Based Rendering, SIGGRAPH course notes (2014), 4.7
template <std::floating_point T>
[[nodiscard]] SolidAngle<T> projected_solid_angle(const Sphere<T>& sphere) {
    const T d = length(sphere.centre);
    if (d < sphere.radius) return SolidAngle<T>{std::numbers::pi_v<T>};
    const T s = sphere.radius / d, cosine = sphere.centre.z / d;
    if (cosine >= s) return SolidAngle<T>{std::numbers::pi_v<T> * square(s) * cosine};
    if (cosine <= -s) return SolidAngle<T>{0};
    const T sine = std::hypot(sphere.centre.x, sphere.centre.y) / d;
    const T x    = std::sqrt((1 - s) * (1 + s)) / s;  // cotangent of the sphere's half-angle
    const T y    = std::clamp(-x * cosine / sine, T{-1}, T{1});
    const T w    = sine * std::sqrt((1 - y) * (1 + y));
    return SolidAngle<T>{(cosine * std::acos(y) - x * w) * square(s) + std::atan2(w, x)};
}

/// A disk's, seen from either side, equation (5.18). As nothing is hidden, light from all its points adds up to a
/// vector, whose part along the normal counts.
/// @pre    |normal| = 1, radius > 0
/// @throws std::invalid_argument if a part of the disk is below the horizon
/// @see    Howell, A Catalog of Radiation Heat Transfer Configuration Factors, B-12, B-13 and B-16
template <std::floating_point T>
[[nodiscard]] SolidAngle<T> projected_solid_angle(const Disk<T>& disk) {
    const T R      = disk.radius;
    const T lowest = disk.centre.z - R * std::hypot(disk.normal.x, disk.normal.y);
    if (!(lowest >= -4 * std::numeric_limits<T>::epsilon() * R))
        throw std::invalid_argument(fmt::format(
            "disk: its lowest point is at z = {}; must be above the receiver's horizon, z = 0", lowest));
    const T          h       = dot(disk.centre, disk.normal);
    const Vector3<T> lateral = disk.centre - h * disk.normal;
    const T          a2 = dot(lateral, lateral), h2 = square(h), R2 = square(R);
    const T          m = a2 + h2 - R2, q = std::hypot(m, 2 * R * h);
    // (q - m) / 2q without cancellation
    const T          forward = m > 0 ? 2 * R2 * h2 / (q * (q + m)) : (q - m) / (2 * q);
    const T          aside   = 2 * std::abs(h) * R2 / (q * (a2 + h2 + R2 + q));
    return SolidAngle<T>{std::numbers::pi_v<T> *
                         ((h < 0 ? -forward : forward) * disk.normal.z + aside * lateral.z)};
}

/// A polygon's, equation (5.19): each edge counts the angle under which it is seen times the cosine of the plane
/// through it and the receiver. The part below the horizon is cut off.
/// @see Lambert, Photometria (1760); Arvo, The Irradiance Jacobian for Partially Occluded Polyhedral Sources (1994)
template <std::floating_point T>
[[nodiscard]] SolidAngle<T> projected_solid_angle(std::span<const Vector3<T>> polygon) {
    T          sum      = 0;
    const auto add_edge = [&sum](const Vector3<T>& p, const Vector3<T>& q) {
        const Vector3<T> edge = q - p, normal = cross(p, edge);
        if (normal.z == 0) return;  // an upright plane's cosine; walls have many
        const T size = length(normal);
        if (size != 0) sum += std::atan2(size, dot(p, p + edge)) * (normal.z / size);
    };
    std::optional<Vector3<T>> first, last;
    corners_above_horizon(polygon, [&](const Vector3<T>& corner) {
        if (last) add_edge(*last, corner);
        if (!first) first = corner;
        last = corner;
    });
    if (first) add_edge(*last, *first);
    return SolidAngle<T>{std::abs(sum) / 2};
}

template <std::floating_point T>
[[nodiscard]] SolidAngle<T> projected_solid_angle(const std::vector<Vector3<T>>& polygon) {
    return projected_solid_angle(std::span(polygon));
}

}  // namespace sr
