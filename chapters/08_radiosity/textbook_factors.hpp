#pragma once
/// @file textbook_factors.hpp
/// Closed forms as the catalogues print them, which lose their digits from afar.

#include <cmath>
#include <concepts>
#include <numbers>

#include "math/square.hpp"

namespace sr {

/// Hottel's formula for two opposed unit squares at the distance c [sides].
template <std::floating_point T>
[[nodiscard]] T textbook_opposed_squares(T c) {
    const T X = 1 / c, X2 = X * X, root = std::sqrt(1 + X2);
    return 2 / (std::numbers::pi_v<T> * X2) *
           (std::log(std::sqrt((1 + X2) * (1 + X2) / (1 + X2 + X2))) + 2 * X * root * std::atan(X / root) -
            2 * X * std::atan(X));
}

/// The root with the minus sign, for two unit disks on one axis at the distance h [radii].
template <std::floating_point T>
[[nodiscard]] T textbook_unit_disks(T h) {
    const T X = 2 + square(h);
    return (X - std::sqrt(X * X - 4)) / 2;
}

}  // namespace sr
