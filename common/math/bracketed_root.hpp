#pragma once
/// @file bracketed_root.hpp
/// Roots between two points where a function has different signs. No step leaves the bracket, so that nothing
/// diverges; and signs are compared, never multiplied: the product of two small values underflows to 0.

#include <algorithm>
#include <cmath>
#include <concepts>
#include <limits>
#include <optional>

#include "math/interval.hpp"

namespace sr {

/// Whether one value is negative and the other positive; false where one is 0 or NaN.
template <std::floating_point T>
[[nodiscard]] constexpr bool opposite_signs(T a, T b) {
    return (a < 0 && b > 0) || (a > 0 && b < 0);
}

/// Whether there are numbers between the ends, all of them finite.
template <std::floating_point T>
[[nodiscard]] bool is_bracket(Interval<T> range) {
    return !range.empty() && std::isfinite(range.min) && std::isfinite(range.max);
}

/// The last float of the bracket before f changes its sign, or one at which f is 0: the bracket is halved until its
/// ends are neighbours, which takes about as many steps as the type has bits between them.
/// None where f does not change its sign strictly from one end to the other, or is NaN on the way, or where the
/// bracket is empty or infinite.
/// @param f  T -> T
template <std::floating_point T, class F>
[[nodiscard]] std::optional<T> bisect(const F& f, Interval<T> bracket) {
    if (!is_bracket(bracket)) return std::nullopt;
    T       a = bracket.min, b = bracket.max;
    const T at_a = f(a), at_b = f(b);
    if (at_a == 0) return a;
    if (at_b == 0) return b;
    if (!opposite_signs(at_a, at_b)) return std::nullopt;
    for (;;) {
        const T middle = a / 2 + b / 2;  // (a + b) / 2 may overflow
        if (!(a < middle && middle < b)) return a;
        const T value = f(middle);
        if (value == 0) return middle;
        if (opposite_signs(value, at_b)) {
            a = middle;
        } else if (opposite_signs(value, at_a)) {
            b = middle;
        } else {
            return std::nullopt;
        }
    }
}

/// A root within two units in the last place, by Chandrupatla's method: a parabola through three points says where
/// to look next, and the middle of the bracket does where the parabola can't be trusted. A smooth f is asked about
/// ten times, where `bisect` asks it 30 (float) or 60 times (double); the worst f a few times as often as there.
/// None as in `bisect`.
/// @param f  T -> T
/// @see Chandrupatla, A new hybrid quadratic/bisection algorithm for finding the zero of a nonlinear function
///      without using derivatives, Advances in Engineering Software 28 (1997)
template <std::floating_point T, class F>
[[nodiscard]] std::optional<T> bracketed_root(const F& f, Interval<T> bracket) {
    if (!is_bracket(bracket)) return std::nullopt;
    constexpr int trusted_steps = 40;  // beyond, halving is what certainly ends
    T             a = bracket.max, b = bracket.min;
    T             at_a = f(a), at_b = f(b);
    if (at_b == 0) return b;
    if (at_a == 0) return a;
    if (!opposite_signs(at_a, at_b)) return std::nullopt;

    T share = T(0.5);  // of the way from a, the newest point, to b, on the other side of the root
    for (int step = 0;; ++step) {
        const T x = share == T(0.5) ? a / 2 + b / 2 : a + share * (b - a);
        if (!(std::min(a, b) < x && x < std::max(a, b))) return std::abs(at_a) < std::abs(at_b) ? a : b;
        const T value = f(x);
        if (value == 0) return x;
        // c, the third point, is what x replaces.
        T c = a, at_c = at_a;
        if (opposite_signs(value, at_a)) {
            c    = b;
            at_c = at_b;
            b    = a;
            at_b = at_a;
        } else if (!opposite_signs(value, at_b)) {
            return std::nullopt;
        }
        a    = x;
        at_a = value;

        const T best      = std::abs(at_a) < std::abs(at_b) ? a : b;
        const T tolerance = std::numeric_limits<T>::epsilon() * std::abs(best);
        const T least     = tolerance / std::abs(b - a);  // of the bracket: a step that still moves x
        if (!(least < T(0.5)) && step < trusted_steps) return best;
        const T xi  = (a - b) / (c - b);
        const T phi = (at_a - at_b) / (at_c - at_b);
        if (step < trusted_steps && phi * phi < xi && (1 - phi) * (1 - phi) < 1 - xi) {
            share = at_a / (at_b - at_a) * at_c / (at_b - at_c) +
                    (c - a) / (b - a) * at_a / (at_c - at_a) * at_b / (at_c - at_b);
            share = std::clamp(share, least, 1 - least);
        } else {
            share = T(0.5);
        }
    }
}

}  // namespace sr
