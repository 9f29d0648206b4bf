#pragma once
/// @file textbook_quartic.hpp
/// Ferrari's formula for the roots of a quartic, as books give it: right, and of little use where the quartic is even
/// about a point.

#include <algorithm>
#include <cmath>
#include <concepts>
#include <numbers>

#include "math/polynomial.hpp"
#include "math/polynomial_roots.hpp"
#include "math/square.hpp"

namespace sr {

/// The largest real root of x^3 + a x^2 + b x + c, by Cardano's formula or by cosines.
template <std::floating_point T>
[[nodiscard]] T textbook_cubic_root(T a, T b, T c) {
    const T q            = (3 * b - a * a) / 9;
    const T r            = (9 * a * b - 27 * c - 2 * a * a * a) / 54;
    const T discriminant = q * q * q + r * r;
    if (discriminant >= 0) {
        const T root = std::sqrt(discriminant);
        return std::cbrt(r + root) + std::cbrt(r - root) - a / 3;
    }
    const T angle = std::acos(std::clamp(r / std::sqrt(-q * q * q), T(-1), T(1)));
    return 2 * std::sqrt(-q) * std::cos(angle / 3) - a / 3;
}

/// The real roots of a quartic, in no order, by splitting it into two quadratics with the help of a cubic.
/// @pre p.c[4] != 0
/// @see Abramowitz & Stegun, Handbook of Mathematical Functions (1964), section 3.8
template <std::floating_point T>
[[nodiscard]] RootList<T, 4> textbook_quartic_roots(const Polynomial<T, 4>& p) {
    const T a = p.c[3] / p.c[4], b = p.c[2] / p.c[4], c = p.c[1] / p.c[4], d = p.c[0] / p.c[4];
    // t = y - a / 4 leaves y^4 + f y^2 + g y + h.
    const T f = b - 3 * a * a / 8;
    const T g = c + a * a * a / 8 - a * b / 2;
    const T h = d - 3 * square(a * a) / 256 + a * a * b / 16 - a * c / 4;
    const T m = textbook_cubic_root(f, square(f) / 4 - h, -square(g) / 8);

    // y^4 + f y^2 + g y + h = (y^2 + f/2 + m)^2 - 2 m (y - g / (4 m))^2, or with g = 0 a quadratic in y^2.
    RootList<T, 4> result;
    const auto     add = [&](T half_sum, T discriminant) {
        if (!(discriminant >= 0)) return;
        result.root[result.count++] = half_sum - std::sqrt(discriminant) - a / 4;
        result.root[result.count++] = half_sum + std::sqrt(discriminant) - a / 4;
    };
    if (m > 0) {
        const T s = std::sqrt(2 * m);
        add(s / 2, -(f + m + g / s) / 2);
        add(-s / 2, -(f + m - g / s) / 2);
    } else {
        add(0, -f / 2 + std::sqrt(square(f) / 4 - h));
        add(0, -f / 2 - std::sqrt(square(f) / 4 - h));
    }
    return result;
}

}  // namespace sr
