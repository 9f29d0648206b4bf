#pragma once
/// @file plane.hpp
/// A ray meets a plane.

#include <concepts>
#include <optional>

#include "geometry/ray.hpp"
#include "math/interval.hpp"
#include "math/vector.hpp"

namespace sr {

/// The points p with n . (p - r) = 0: a point r of the plane, and a normal n of any length but zero.
template <std::floating_point T>
struct Plane {
    Vector3<T> point;
    Vector3<T> normal;
};

/// The t of (2.2), if it is in `range`. None where the ray runs along the plane, even in it.
/// @param ray  direction of any length; t counts in units of |d|
/// @pre   n . d and n . (r - o) neither overflow nor underflow; what is not finite is missed
template <std::floating_point T>
[[nodiscard]] std::optional<T> intersect(const Plane<T>& plane, const Ray<T>& ray,
                                         Interval<T> range = in_front<T>) {
    // The difference comes first: near r it is exact, where n . r - n . o would have lost the distance.
    const T t = dot(plane.normal, plane.point - ray.origin) / dot(plane.normal, ray.direction);
    if (!range.contains(t)) return std::nullopt;  // nor is 0 / 0 in it
    return t;
}

}  // namespace sr
