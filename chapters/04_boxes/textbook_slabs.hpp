#pragma once
/// @file textbook_slabs.hpp
/// A ray against the slabs of a box as textbooks have it, and where each form goes wrong. BoxRay is the cure.

#include <algorithm>
#include <cmath>
#include <concepts>
#include <limits>

#include "geometry/box.hpp"
#include "math/interval_arithmetic.hpp"

namespace sr {

/// The three ways to write "the larger entry, the smaller exit"; they differ where one of two is NaN.
enum class MinMax {
    running_first,   ///< std::max(entry, t): keeps the running value
    running_second,  ///< std::max(t, entry): lets NaN in, and the next axis lets it out again
    ieee             ///< std::fmax, std::fmin: the other operand, whichever it is
};

/// (4.2), (4.3) with the reciprocal of the direction; 0 times infinity is NaN.
template <std::floating_point T>
[[nodiscard]] Interval<T> textbook_clip(const Ray<T>& ray, const Box<T>& box, MinMax how) {
    Interval<T> range = whole_line<T>;
    for (int axis = 0; axis < 3; ++axis) {
        const T inverse = 1 / ray.direction[axis];
        const T a       = (box.min[axis] - ray.origin[axis]) * inverse;
        const T b       = (box.max[axis] - ray.origin[axis]) * inverse;
        switch (how) {
            case MinMax::running_first:
                range = {std::max(range.min, std::min(a, b)), std::min(range.max, std::max(a, b))};
                break;
            case MinMax::running_second:
                range = {std::max(std::min(a, b), range.min), std::min(std::max(a, b), range.max)};
                break;
            case MinMax::ieee:
                range = {std::fmax(range.min, std::fmin(a, b)), std::fmin(range.max, std::fmax(a, b))};
                break;
        }
    }
    return range;
}

/// Picks the nearer plane by d < 0, which is false for -0, although 1 / -0 is minus infinity.
template <std::floating_point T>
[[nodiscard]] Interval<T> clip_by_sign_of_direction(const Ray<T>& ray, const Box<T>& box) {
    Interval<T> range = whole_line<T>;
    for (int axis = 0; axis < 3; ++axis) {
        const bool backwards = ray.direction[axis] < 0;
        const T    inverse   = 1 / ray.direction[axis];
        const T    near      = ((backwards ? box.max : box.min)[axis] - ray.origin[axis]) * inverse;
        const T    far       = ((backwards ? box.min : box.max)[axis] - ray.origin[axis]) * inverse;
        range                = {std::max(range.min, near), std::min(range.max, far)};
    }
    return range;
}

/// Right for zeros of both signs, and the exits lengthened by any factor.
/// @param padding  1: as textbooks have it
template <std::floating_point T>
[[nodiscard]] Interval<T> padded_clip(const Ray<T>& ray, const Box<T>& box, T padding) {
    Interval<T> range = in_front<T>;
    for (int axis = 0; axis < 3; ++axis) {
        const T    inverse   = 1 / ray.direction[axis];
        const bool backwards = std::signbit(inverse);
        const T    near      = ((backwards ? box.max : box.min)[axis] - ray.origin[axis]) * inverse;
        const T    far       = ((backwards ? box.min : box.max)[axis] - ray.origin[axis]) * inverse * padding;
        range                = {near > range.min ? near : range.min, far < range.max ? far : range.max};
    }
    return range;
}

/// 1 + 2 gamma_3, equation (4.5): three roundings in the entry and three in the exit.
template <std::floating_point T>
inline constexpr T ize_padding = 1 + 6 * (std::numeric_limits<T>::epsilon() / 2) /
                                         (1 - 3 * std::numeric_limits<T>::epsilon() / 2);

}  // namespace sr
