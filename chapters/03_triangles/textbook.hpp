#pragma once
/// @file textbook.hpp
/// How triangles are intersected and measured where numbers have no end: the forms that section 3.7 sees fail.

#include <cmath>
#include <concepts>
#include <optional>

#include "geometry/triangle.hpp"

namespace sr::textbook {

/// As `intersect_moeller_trumbore`, but a determinant below `epsilon` is taken for that of a parallel ray.
/// @see Moeller & Trumbore, Journal of Graphics Tools 2(1), 1997: epsilon = 10^-6
template <std::floating_point T>
[[nodiscard]] std::optional<Hit<T>> intersect(const Triangle<T>& triangle, const Ray<T>& ray,
                                              Interval<T> range, T epsilon) {
    const Vector3<T> e1 = triangle.b - triangle.a, e2 = triangle.c - triangle.a, s = ray.origin - triangle.a;
    const Vector3<T> p = cross(ray.direction, e2), q = cross(s, e1);
    const T          determinant = dot(p, e1);
    if (std::abs(determinant) < epsilon) return std::nullopt;
    // Written as what makes a miss: a NaN makes none.
    const T u = dot(p, s) / determinant;
    if (u < 0 || u > 1) return std::nullopt;
    const T v = dot(q, ray.direction) / determinant;
    if (v < 0 || u + v > 1) return std::nullopt;
    const T t = dot(q, e2) / determinant;
    if (t < range.min || t > range.max) return std::nullopt;
    return Hit<T>{t, {u, v}};
}

/// Heron's formula: the area of a triangle from its sides, [length unit^2].
template <std::floating_point T>
[[nodiscard]] T heron(T a, T b, T c) {
    const T s = (a + b + c) / 2;
    return std::sqrt(s * (s - a) * (s - b) * (s - c));
}

}  // namespace sr::textbook
