#pragma once
/// @file interval_arithmetic.hpp
/// Arithmetic with intervals: an operation on all numbers of its operands at once. Bounds are rounded outwards, so
/// that the result holds every exact result, rounding or not; and it may hold more. An operation of which nothing is
/// known, such as a division by 0, results in the whole line.
/// @see Moore, Interval Analysis (1966)

#include <algorithm>
#include <concepts>
#include <limits>

#include "math/interval.hpp"

namespace sr {

/// A number less than x by at least one unit in the last place and at most three, so that it lies below
/// whatever was rounded to x. Of infinity, the largest number.
template <std::floating_point T>
[[nodiscard]] constexpr T rounded_down(T x) {
    using Limits = std::numeric_limits<T>;
    if (x > Limits::max()) return Limits::max();
    return x - ((x < 0 ? -x : x) * Limits::epsilon() + Limits::min());
}

template <std::floating_point T>
[[nodiscard]] constexpr T rounded_up(T x) {
    return -rounded_down(-x);
}

template <std::floating_point T>
inline constexpr Interval<T> whole_line{-std::numeric_limits<T>::infinity(),
                                        std::numeric_limits<T>::infinity()};

/// The interval from the rounded min to the rounded max; the whole line if one of them is NaN.
template <std::floating_point T>
[[nodiscard]] constexpr Interval<T> rounded_outwards(T min, T max) {
    if (!(min <= max)) return whole_line<T>;
    return {rounded_down(min), rounded_up(max)};
}

/// Both intervals and what lies between them.
template <std::floating_point T>
[[nodiscard]] constexpr Interval<T> hull(Interval<T> a, Interval<T> b) {
    return {std::min(a.min, b.min), std::max(a.max, b.max)};
}

template <std::floating_point T>
[[nodiscard]] constexpr T magnitude(Interval<T> a) {
    return std::max(-a.min, a.max);
}

template <std::floating_point T>
[[nodiscard]] constexpr Interval<T> operator-(Interval<T> a) {
    return {-a.max, -a.min};
}
template <std::floating_point T>
[[nodiscard]] constexpr Interval<T> operator+(Interval<T> a, Interval<T> b) {
    return rounded_outwards(a.min + b.min, a.max + b.max);
}
template <std::floating_point T>
[[nodiscard]] constexpr Interval<T> operator-(Interval<T> a, Interval<T> b) {
    return rounded_outwards(a.min - b.max, a.max - b.min);
}

/// The least and the largest of four corners.
template <std::floating_point T>
[[nodiscard]] constexpr Interval<T> rounded_outwards(T a, T b, T c, T d) {
    const T sum = a + b + c + d;
    if (!(sum == sum)) return whole_line<T>;  // 0 infinity: std::min would hide the NaN
    return rounded_outwards(std::min(std::min(a, b), std::min(c, d)),
                            std::max(std::max(a, b), std::max(c, d)));
}

template <std::floating_point T>
[[nodiscard]] constexpr Interval<T> operator*(Interval<T> a, Interval<T> b) {
    return rounded_outwards(a.min * b.min, a.min * b.max, a.max * b.min, a.max * b.max);
}
template <std::floating_point T>
[[nodiscard]] constexpr Interval<T> operator/(Interval<T> a, Interval<T> b) {
    if (!(b.min > 0 || b.max < 0)) return whole_line<T>;
    return rounded_outwards(a.min / b.min, a.min / b.max, a.max / b.min, a.max / b.max);
}

/// Tighter than a a, which does not know that both factors are the same number.
template <std::floating_point T>
[[nodiscard]] constexpr Interval<T> square(Interval<T> a) {
    const T least  = a.contains(0) ? T{0} : std::min(a.min * a.min, a.max * a.max);
    auto    result = rounded_outwards(least, std::max(a.min * a.min, a.max * a.max));
    result.min     = std::max(result.min, T{0});
    return result;
}

// With numbers.
template <std::floating_point T>
[[nodiscard]] constexpr Interval<T> operator+(Interval<T> a, T b) {
    return a + Interval<T>{b, b};
}
template <std::floating_point T>
[[nodiscard]] constexpr Interval<T> operator-(Interval<T> a, T b) {
    return a - Interval<T>{b, b};
}
template <std::floating_point T>
[[nodiscard]] constexpr Interval<T> operator*(Interval<T> a, T b) {
    return a * Interval<T>{b, b};
}
template <std::floating_point T>
[[nodiscard]] constexpr Interval<T> operator/(Interval<T> a, T b) {
    return a / Interval<T>{b, b};
}
template <std::floating_point T>
[[nodiscard]] constexpr Interval<T> operator/(T a, Interval<T> b) {
    return Interval<T>{a, a} / b;
}

}  // namespace sr
