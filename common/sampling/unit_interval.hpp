#pragma once
/// @file unit_interval.hpp

#include <concepts>
#include <cstdint>

namespace sr {

/// Random bits as a multiple of 2^-24 in [0, 1). Never 1: the bits that the type can't hold are dropped, where x *
/// 2^-32 would round the largest x up.
template <std::same_as<float> T>
[[nodiscard]] constexpr T to_unit_interval(std::uint32_t bits) {
    return T(bits >> 8) * T{0x1p-24};
}

/// 64 bits as a multiple of 2^-53.
template <std::same_as<double> T>
[[nodiscard]] constexpr T to_unit_interval(std::uint64_t bits) {
    return T(bits >> 11) * T{0x1p-53};
}

}  // namespace sr
