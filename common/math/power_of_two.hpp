#pragma once
/// @file power_of_two.hpp

#include <bit>
#include <concepts>
#include <cstdint>
#include <limits>
#include <type_traits>

namespace sr {

/// The largest power of two not above |x|; 0 of what is too small for digits of its own, infinity of what is not
/// finite. A product with it changes no digit.
template <std::floating_point T>
[[nodiscard]] constexpr T power_of_two_in(T x) {
    using Bits = std::conditional_t<sizeof(T) == 4, std::uint32_t, std::uint64_t>;
    constexpr auto exponent =
        std::bit_cast<Bits>(std::numeric_limits<T>::infinity());  // all of its bits, no digit
    return std::bit_cast<T>(std::bit_cast<Bits>(x) & exponent);
}

}  // namespace sr
