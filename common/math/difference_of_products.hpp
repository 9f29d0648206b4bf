#pragma once
/// @file difference_of_products.hpp

#include <cmath>
#include <concepts>

namespace sr {

/// a b - c d within 1.5 units in the last place, so that its sign is that of the exact value (barring
/// underflow). The plain expression loses every digit when the two products nearly agree.
/// @see Kahan's algorithm; Jeannerod, Louvet & Muller, Further analysis of Kahan's algorithm for the accurate
///      computation of 2 x 2 determinants, Math. Comp. 82 (2013)
template <std::floating_point T>
[[nodiscard]] inline T difference_of_products(T a, T b, T c, T d) {
    const T cd    = c * d;
    const T error = std::fma(-c, d, cd);  // what rounding took from c d
    return std::fma(a, b, -cd) + error;
}

}  // namespace sr
