#pragma once
/// @file moeller_trumbore.hpp
/// A ray meets a triangle by Cramer's rule: nothing is computed beforehand, for neither of the two.

#include <concepts>
#include <optional>

#include "geometry/ray.hpp"
#include "geometry/triangle.hpp"
#include "math/interval.hpp"
#include "math/vector.hpp"

namespace sr {

/// Where in `range` the ray meets the triangle, from either side, equation (3.5). Where the determinant is 0, or too
/// small for the division, the results are infinite or NaN, and miss.
///
/// Each triangle is asked by itself, with its own rounding: a ray at an edge that two triangles share may
/// miss both. TriangleRay does not leak.
/// @see Moeller & Trumbore, Fast, Minimum Storage Ray-Triangle Intersection, Journal of Graphics Tools 2(1), 1997
template <std::floating_point T>
[[nodiscard]] std::optional<Hit<T>> intersect_moeller_trumbore(const Triangle<T>& triangle, const Ray<T>& ray,
                                                               Interval<T> range) {
    // (3.5) the 3 x 3 system by Cramer's rule: three determinants share two cross products
    const Vector3<T> e1 = triangle.b - triangle.a, e2 = triangle.c - triangle.a;
    const Vector3<T> s = ray.origin - triangle.a;
    const Vector3<T> p = cross(ray.direction, e2), q = cross(s, e1);
    const T          determinant = dot(p, e1);
    const T          b1          = dot(p, s) / determinant;
    const T          b2          = dot(q, ray.direction) / determinant;
    const T          t           = dot(q, e2) / determinant;

    if (!(b1 >= 0 && b2 >= 0 && b1 + b2 <= 1 && range.contains(t))) return std::nullopt;
    return Hit<T>{t, {b1, b2}};
}

}  // namespace sr
