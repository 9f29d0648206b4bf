#pragma once
/// @file unit_interval.hpp

#include <concepts>
#include <cstdint>
#include <limits>

namespace sr {

/// The largest number below 1.
template <std::floating_point T>
inline constexpr T largest_below_1 = 1 - std::numeric_limits<T>::epsilon() / 2;

/// 64 random bits as a multiple of 2^-24 (float) or 2^-53 (double) in [0, 1), by the uppermost of them. Never 1: the
/// bits that the type can't hold are dropped, where x * 2^-64 would round the largest x up.
template <std::floating_point T>
[[nodiscard]] constexpr T to_unit_interval(std::uint64_t bits) {
    if constexpr (sizeof(T) == sizeof(float))
        return T(bits >> 40) * T{0x1p-24};
    else
        return T(bits >> 11) * T{0x1p-53};
}

}  // namespace sr
