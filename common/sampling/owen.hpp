#pragma once
/// @file owen.hpp

#include <cstdint>

namespace sr {

/// The 32 bits in the opposite order.
[[nodiscard]] constexpr std::uint32_t reversed_bits(std::uint32_t v) {
    v = (v >> 1 & 0x55555555U) | (v & 0x55555555U) << 1;
    v = (v >> 2 & 0x33333333U) | (v & 0x33333333U) << 2;
    v = (v >> 4 & 0x0f0f0f0fU) | (v & 0x0f0f0f0fU) << 4;
    v = (v >> 8 & 0x00ff00ffU) | (v & 0x00ff00ffU) << 8;
    return v >> 16 | v << 16;
}

/// Owen's scrambling of a fraction 0.b1 b2 ...: whether bit k is turned over depends, at random, on the bits before
/// it and on nothing else. Halves change places, and in each of them quarters, and so on: however the points of a set
/// share out such intervals, they go on doing so, and each of them is now uniform in [0, 1). The dependence is that
/// of a hash, which in reversed order only has to carry upwards. What it does to any two intervals is independent,
/// and variances are therefore those of Owen's own; of three and more it isn't: 2^32 seeds are too few.
/// @param bits  the fraction, times 2^32
/// @see Owen, Randomly Permuted (t,m,s)-Nets and (t,s)-Sequences (1995); Laine and Karras (2011); Burley, Practical
///      Hash-based Owen Scrambling (JCGT 9(4), 2020); the constants are Vegdahl's (2021)
[[nodiscard]] constexpr std::uint32_t owen_scrambled(std::uint32_t bits, std::uint32_t seed) {
    // in reversed order, products and sums carry from the bits before to those after
    std::uint32_t v = reversed_bits(bits);
    v ^= v * 0x3d20adea;
    v += seed;
    v *= seed >> 16 | 1;
    v ^= v * 0x05526c56;
    v ^= v * 0x53a22864;
    return reversed_bits(v);
}

}  // namespace sr
