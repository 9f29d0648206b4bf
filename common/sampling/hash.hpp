#pragma once
/// @file hash.hpp

#include <concepts>
#include <cstdint>

namespace sr {

/// A step of splitmix64: a bijection of 64 bits in which each bit of the input turns over half of the output's.
/// @see Steele, Lea and Flood, Fast Splittable Pseudorandom Number Generators (2014)
[[nodiscard]] constexpr std::uint64_t scramble(std::uint64_t value) {
    value += 0x9e3779b97f4a7c15;
    value = (value ^ (value >> 30)) * 0xbf58476d1ce4e5b9;
    value = (value ^ (value >> 27)) * 0x94d049bb133111eb;
    return value ^ (value >> 31);
}

/// One number of several, their order included.
template <std::integral... More>
[[nodiscard]] constexpr std::uint64_t hash(std::uint64_t first, More... more) {
    std::uint64_t h = scramble(first);
    ((h = scramble(h ^ std::uint64_t(more))), ...);
    return h;
}

}  // namespace sr
