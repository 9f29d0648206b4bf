#pragma once
/// @file triangle_points.hpp
/// Points of a triangle, each as likely, in the triple sample, pdf, invert. A point is what it weighs the second corner
/// and the third with: (1 - x - y) a + x b + y c, as in a `Hit`.

#include <cmath>
#include <concepts>

#include "math/square.hpp"
#include "math/vector.hpp"
#include "sampling/pdf.hpp"

namespace sr {

/// The part cut off at the corner b, by a parallel to the opposite side at the share s of the height, has the share s^2
/// of the area: s = sqrt(u.x). On that parallel, u.y is uniform.
/// @pre    0 <= u.x < 1 and 0 <= u.y < 1
/// @return neither is negative, and their sum is at most 1, as 1 - (1 - s) is exact
/// @see    Turk, Generating Random Points in Triangles, Graphics Gems (1990)
template <std::floating_point T>
[[nodiscard]] Vector2<T> sample_triangle(Vector2<T> u) {
    const T b = 1 - std::sqrt(u.x);
    return {b, u.y * (1 - b)};
}

/// 1 / area, and 0 of weights outside of the triangle.
/// @param area  of the triangle, > 0
template <std::floating_point T>
[[nodiscard]] Pdf<measure::Area> pdf_triangle(const Vector2<T>& weights, T area) {
    const bool inside = weights.x >= 0 && weights.y >= 0 && weights.x + weights.y <= 1;
    return {inside ? 1 / double(area) : 0};
}

/// At the corner b itself every u.y is mapped to one point: 0 stands for it.
template <std::floating_point T>
[[nodiscard]] Vector2<T> invert_triangle(const Vector2<T>& weights) {
    const T s = 1 - weights.x;
    return {square(s), s > 0 ? weights.y / s : 0};
}

}  // namespace sr
