#pragma once
/// @file closed_form_factors.hpp
/// Form factors F_12 [1] that are known: the share of the light leaving the first of two surfaces that arrives at the
/// second, with nothing between them. Lengths are in any one unit.
/// @see Howell, A Catalog of Radiation Heat Transfer Configuration Factors: C-11, C-14 and C-41

#include <algorithm>
#include <cmath>
#include <numbers>

#include "math/square.hpp"

namespace sr {

/// Two equal rectangles a x b that face each other directly at the distance c. From 30 sides away it is a series of
/// the sides' squares, of which four terms are right to 12 digits: Hottel's formula subtracts numbers of the size of
/// (a/c)^2 to get one of the size.
/// @pre a, b, c > 0; a and b differ by a factor of 1000 at most, or digits are lost in the shorter one
/// @see Hottel, Radiant Heat Transmission Between Surfaces Separated by Non-Absorbing Media, Trans. ASME 53 (1931)
[[nodiscard]] inline double opposed_rectangles(double a, double b, double c) {
    const double X = a / c, Y = b / c, X2 = square(X), Y2 = square(Y);
    if (30 * std::max(a, b) < c)
        return X * Y / std::numbers::pi *
               (1 - (X2 + Y2) / 3 + (square(X2) + square(Y2)) / 5 + X2 * Y2 / 6 -
                (X2 * square(X2) + Y2 * square(Y2)) / 7 - 2 * X2 * Y2 * (X2 + Y2) / 15);
    const double x = std::sqrt(1 + X2), y = std::sqrt(1 + Y2);
    return 2 / (std::numbers::pi * X * Y) *
           (std::log1p(X2 * Y2 / (1 + X2 + Y2)) / 2 + X * (y * std::atan(X / y) - std::atan(X)) +
            Y * (x * std::atan(Y / x) - std::atan(Y)));
}

/// From a rectangle l x w to another, l x h, at a right angle along their common side l.
/// @pre l, w, h > 0
/// @see Hamilton and Morgan, Radiant-Interchange Configuration Factors, NACA TN 2836 (1952)
[[nodiscard]] inline double perpendicular_rectangles(double l, double w, double h) {
    const double W = w / l, H = h / l, W2 = square(W), H2 = square(H);
    const double both = 1 + W2 + H2, D = std::hypot(W, H);
    const double logs = std::log((1 + W2) * (1 + H2) / both) +
                        W2 * std::log(W2 * both / ((1 + W2) * (W2 + H2))) +
                        H2 * std::log(H2 * both / ((1 + H2) * (W2 + H2)));
    return (W * std::atan(1 / W) + H * std::atan(1 / H) - D * std::atan(1 / D) + logs / 4) /
           (std::numbers::pi * W);
}

/// From a disk of radius r1 to another of radius r2 on the same axis, parallel, at the distance h: the smaller root of
/// a quadratic equation, whose product with the larger one is (r2/r1)^2.
/// @pre r1, r2 > 0, h >= 0
[[nodiscard]] inline double coaxial_disks(double r1, double r2, double h) {
    const double q = r2 / r1;
    // X - 2 q, without cancellation
    const double less = (square(h) + square(r1 - r2)) / square(r1);
    const double X    = less + 2 * q;
    return 2 * square(q) / (X + std::sqrt(less * (X + 2 * q)));
}

}  // namespace sr
