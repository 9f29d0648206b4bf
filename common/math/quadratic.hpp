#pragma once
/// @file quadratic.hpp
/// The roots of a quadratic, each with all the digits that its coefficients determine.
///
///     if (const auto roots = quadratic_roots(a, b, c)) use(roots->first_in(range));

#include <cmath>
#include <concepts>
#include <limits>
#include <optional>

#include "math/difference_of_products.hpp"
#include "math/interval.hpp"

namespace sr {

/// Two real roots, first <= second: the same number twice where they coincide. One beyond the largest number of
/// the type is infinite.
template <std::floating_point T>
struct Roots {
    T first, second;

    /// The least finite root in the range.
    [[nodiscard]] std::optional<T> first_in(Interval<T> range) const {
        for (const T root : {first, second}) {
            if (range.contains(root)) return root;
        }
        return std::nullopt;
    }
};

/// The real roots of a t^2 + 2 b t + c where somebody knows b^2 - a c better than it can be computed from a, b
/// and c. With a = 0 there is one root, and it is given twice. None where the discriminant is negative, infinite
/// or NaN, or where a = b = 0.
/// @see Press et al., Numerical Recipes, 3rd ed. (2007), section 5.6
template <std::floating_point T>
[[nodiscard]] std::optional<Roots<T>> quadratic_roots(T a, T b, T c, T discriminant) {
    if (!(discriminant >= 0 && discriminant <= std::numeric_limits<T>::max())) return std::nullopt;
    // The root farther from 0 is a sum of numbers of one sign; the other follows from their product, c / a. The
    // school's formula computes one of the two as a difference of nearly equal numbers.
    const T q = -(b + std::copysign(std::sqrt(discriminant), b));
    if (q == 0) {  // b = 0, and a or c is
        if (a == 0) return std::nullopt;
        return Roots<T>{0, 0};
    }
    const T near = c / q;
    const T far  = a == 0 ? near : q / a;
    if (near <= far) return Roots<T>{near, far};
    if (far <= near) return Roots<T>{far, near};
    return std::nullopt;  // NaN
}

/// The same of any three numbers whose products do not overflow. The discriminant has the sign of the exact one,
/// so that a double root is neither lost nor torn in two.
template <std::floating_point T>
[[nodiscard]] std::optional<Roots<T>> quadratic_roots(T a, T b, T c) {
    return quadratic_roots(a, b, c, difference_of_products(b, b, a, c));
}

}  // namespace sr
