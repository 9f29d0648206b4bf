#pragma once
/// @file difference_of_squares.hpp

#include <cmath>
#include <concepts>
#include <initializer_list>

#include "math/vector.hpp"

namespace sr {

/// |v|^2 - r^2 as if computed with twice the digits and then rounded, so that its sign and its digits are right even
/// where the two squares nearly agree, equation (2.16); barring underflow. The plain expression rounds the squares, and
/// (|v| - r)(|v| + r) the length.
/// @see Ogita, Rump & Oishi, Accurate Sum and Dot Product, SIAM J. Sci. Comput. 26(6), 2005: Dot2
template <std::floating_point T>
[[nodiscard]] T difference_of_squares(const Vector3<T>& v, T r) {
    // What rounding takes from a product or a sum is a number of the type: it is computed, and added at the end.
    T sum   = -r * r;
    T error = std::fma(-r, r, -sum);
    for (const T x : {v.x, v.y, v.z}) {
        const T square = x * x;
        const T next   = sum + square;
        const T added  = next - sum;
        error += std::fma(x, x, -square) + ((sum - (next - added)) + (square - added));
        sum = next;
    }
    return sum + error;
}

}  // namespace sr
