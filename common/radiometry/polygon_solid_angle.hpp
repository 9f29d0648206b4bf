#pragma once
/// @file polygon_solid_angle.hpp

#include <cmath>
#include <concepts>
#include <cstddef>
#include <vector>

#include "geometry/triangle.hpp"
#include "math/vector.hpp"
#include "radiometry/quantity.hpp"

namespace sr {

/// A triangle's solid angle from the origin with a sign, equation (5.8): positive where its front is seen. No arc
/// cosine is taken, so that a small one keeps its digits; and atan2, not atan, because beyond pi the denominator is
/// negative.
/// @see Van Oosterom and Strackee, The Solid Angle of a Plane Triangle, IEEE Trans. Biomed. Eng. 30 (1983)
template <std::floating_point T>
[[nodiscard]] SolidAngle<T> signed_solid_angle(const Triangle<T>& triangle) {
    const auto& [a, b, c] = triangle;
    // a . (b x c), from the edges: of a distant triangle they are small, and what is subtracted is not the product
    const T volume = dot(a, area_vector(triangle));
    const T la = length(a), lb = length(b), lc = length(c);
    const T rest = la * lb * lc + dot(a, b) * lc + dot(a, c) * lb + dot(b, c) * la;
    return SolidAngle<T>{-2 * std::atan2(volume, rest)};
}

template <std::floating_point T>
[[nodiscard]] SolidAngle<T> solid_angle(const Triangle<T>& triangle) {
    return SolidAngle<T>{std::abs(signed_solid_angle(triangle).value())};
}

/// The solid angle from the origin of a plane polygon of any shape that does not cross itself: a fan of triangles,
/// those that lie outside counted negatively.
template <std::floating_point T>
[[nodiscard]] SolidAngle<T> solid_angle(const std::vector<Vector3<T>>& polygon) {
    SolidAngle<T> sum;
    for (std::size_t i = 2; i < polygon.size(); ++i)
        sum = sum + signed_solid_angle(Triangle<T>{polygon[0], polygon[i - 1], polygon[i]});
    return SolidAngle<T>{std::abs(sum.value())};
}

}  // namespace sr
