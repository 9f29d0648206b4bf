#pragma once
/// @file triangle_methods.hpp
/// The ways to intersect a triangle, asked alike: each is a function of triangle, ray and range.

#include <concepts>
#include <optional>

#include "geometry/moeller_trumbore.hpp"
#include "geometry/plane_triangle.hpp"
#include "geometry/triangle.hpp"

namespace sr::test {

/// Calls check(name, intersect) for each method.
template <std::floating_point T, class Check>
void for_each_triangle_method(Check&& check) {
    check("Moeller-Trumbore", intersect_moeller_trumbore<T>);
    check("plane and edges", [](const Triangle<T>& triangle, const Ray<T>& ray, Interval<T> range) {
        return PlaneTriangle<T>(triangle).intersect(ray, range);
    });
    check("watertight", [](const Triangle<T>& triangle, const Ray<T>& ray, Interval<T> range) {
        return TriangleRay<T>(ray).intersect(triangle, range);
    });
}

}  // namespace sr::test
