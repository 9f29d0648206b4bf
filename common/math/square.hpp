#pragma once
/// @file square.hpp

#include <concepts>

namespace sr {

/// x^2. The other number types have their own, because theirs can say more than x x does: the square of an
/// interval is never negative.
template <std::floating_point T>
[[nodiscard]] constexpr T square(T x) {
    return x * x;
}

}  // namespace sr
