#pragma once
/// @file halton.hpp

#include <array>
#include <cstddef>
#include <cstdint>

namespace sr {

/// The digits of i in base b, mirrored at the point: 0.d0 d1 d2... Of b^k consecutive i, each b^k-th of [0, 1) gets
/// one.
/// @pre    b >= 2, and i has fewer digits than would make b^digits overflow 64 bits: i < 2^64 / b
/// @return in [0, 1), to rounding; the digits themselves are exact
[[nodiscard]] constexpr double radical_inverse(std::uint32_t b, std::uint64_t i) {
    std::uint64_t mirrored = 0, scale = 1;
    for (; i > 0; i /= b, scale *= b) mirrored = mirrored * b + i % b;
    return double(mirrored) / double(scale);
}

inline constexpr std::array<std::uint32_t, 32> halton_primes{2,  3,  5,  7,   11,  13,  17,  19,  23,  29, 31,
                                                             37, 41, 43, 47,  53,  59,  61,  67,  71,  73, 79,
                                                             83, 89, 97, 101, 103, 107, 109, 113, 127, 131};
inline constexpr std::size_t                   halton_dimensions = halton_primes.size();

/// Halton's points: of the i-th, coordinate d is the radical inverse of i in the d-th prime. In high dimensions,
/// pairs of coordinates lie on few lines, until i is more than the product of their primes.
/// @pre d < halton_dimensions, i < 2^48
/// @see Halton, Numerische Mathematik 2 (1960)
[[nodiscard]] constexpr double halton(std::uint64_t i, std::size_t d) {
    return radical_inverse(halton_primes[d], i);
}

}  // namespace sr
