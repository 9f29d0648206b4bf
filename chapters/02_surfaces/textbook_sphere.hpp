#pragma once
/// @file textbook_sphere.hpp
/// The sphere as it is solved at school: right, and of no use far away or on a planet.

#include <cmath>
#include <concepts>
#include <optional>

#include "geometry/ray.hpp"
#include "geometry/sphere.hpp"
#include "math/quadratic.hpp"
#include "math/vector.hpp"

namespace sr {

/// The roots of (2.4) by (-b +- sqrt(b^2 - 4 a c)) / 2 a.
template <std::floating_point T>
[[nodiscard]] std::optional<Roots<T>> textbook_crossings(const Sphere<T>& sphere, const Ray<T>& ray) {
    const Vector3<T> s            = ray.origin - sphere.centre;
    const T          a            = dot(ray.direction, ray.direction);
    const T          b            = 2 * dot(s, ray.direction);
    const T          c            = dot(s, s) - sphere.radius * sphere.radius;
    const T          discriminant = b * b - 4 * a * c;
    if (!(discriminant >= 0)) return std::nullopt;
    const T root = std::sqrt(discriminant);
    return Roots<T>{(-b - root) / (2 * a), (-b + root) / (2 * a)};
}

}  // namespace sr
