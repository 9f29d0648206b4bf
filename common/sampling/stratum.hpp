#pragma once
/// @file stratum.hpp

#include <concepts>

#include "math/vector.hpp"

namespace sr {

/// Of the unit square cut into side^2 squares, counted row by row, a place in the k-th: u of [0, 1)^2 within it.
/// @pre 0 <= k < side^2
template <std::floating_point T>
[[nodiscard]] constexpr Vector2<T> in_stratum(int k, int side, Vector2<T> u) {
    const int column = k % side, row = k / side;
    return {(T(column) + u.x) / T(side), (T(row) + u.y) / T(side)};
}

}  // namespace sr
