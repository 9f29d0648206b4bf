#pragma once
/// @file sobol.hpp

#include <array>
#include <cstddef>
#include <cstdint>

namespace sr {

inline constexpr std::size_t sobol_dimensions = 21;

/// A primitive polynomial over {0, 1}, x^s + a_1 x^(s-1) + ... + a_(s-1) x + 1, and the first s direction numbers.
struct SobolStart {
    std::uint32_t                s, a;
    std::array<std::uint32_t, 7> m;
};

/// Of dimensions 2, 3, ...: the first lines of new-joe-kuo-6.21201.
/// @see Joe and Kuo, Constructing Sobol Sequences with Better Two-Dimensional Projections (2008)
inline constexpr std::array<SobolStart, sobol_dimensions - 1> joe_kuo{{
    {1, 0, {1}},
    {2, 1, {1, 3}},
    {3, 1, {1, 3, 1}},
    {3, 2, {1, 1, 1}},
    {4, 1, {1, 1, 3, 3}},
    {4, 4, {1, 3, 5, 13}},
    {5, 2, {1, 1, 5, 5, 17}},
    {5, 4, {1, 1, 5, 5, 5}},
    {5, 7, {1, 1, 7, 11, 19}},
    {5, 11, {1, 1, 5, 1, 1}},
    {5, 13, {1, 1, 1, 3, 11}},
    {5, 14, {1, 3, 5, 5, 31}},
    {6, 1, {1, 3, 3, 9, 7, 49}},
    {6, 13, {1, 1, 1, 15, 21, 21}},
    {6, 16, {1, 3, 1, 13, 27, 49}},
    {6, 19, {1, 1, 1, 15, 7, 5}},
    {6, 22, {1, 3, 1, 15, 13, 25}},
    {6, 25, {1, 1, 5, 5, 19, 61}},
    {7, 1, {1, 3, 7, 11, 23, 15, 103}},
    {7, 4, {1, 3, 7, 13, 13, 15, 69}},
}};

/// What bit k of the index contributes, times 2^32, k = 0, 1, ... 31: the recurrence of Bratley and Fox (1988).
[[nodiscard]] constexpr std::array<std::uint32_t, 32> sobol_directions(std::size_t dimension) {
    std::array<std::uint32_t, 32> v{};
    if (dimension == 0) {
        for (std::size_t k = 0; k < 32; ++k) v[k] = 1U << (31 - k);
        return v;
    }
    const auto& [s, a, m] = joe_kuo[dimension - 1];
    for (std::size_t k = 0; k < 32; ++k) {
        if (k < s) {
            v[k] = m[k] << (31 - k);
            continue;
        }
        v[k] = v[k - s] ^ v[k - s] >> s;
        for (std::size_t i = 1; i < s; ++i)
            if (a >> (s - 1 - i) & 1) v[k] ^= v[k - i];
    }
    return v;
}

/// What each four bits of the index contribute together: eight exclusive ors a number, for a path needs dozens.
using SobolTable = std::array<std::array<std::uint32_t, 16>, 8>;

inline constexpr auto sobol_tables = [] {
    std::array<SobolTable, sobol_dimensions> all{};
    for (std::size_t d = 0; d < sobol_dimensions; ++d) {
        const auto v = sobol_directions(d);
        for (std::size_t four = 0; four < 8; ++four)
            for (std::size_t bits = 1; bits < 16; ++bits)
                for (std::size_t k = 0; k < 4; ++k)
                    if (bits >> k & 1) all[d][four][bits] ^= v[4 * four + k];
    }
    return all;
}();

/// Sobol's points, times 2^32: coordinate `dimension` of the index-th. In each coordinate, any 2^k points from a
/// multiple of 2^k on are one in each interval of length 2^-k; in the first two together, one in each box of area
/// 2^-k whose sides are such intervals, whatever its shape.
/// @pre dimension < sobol_dimensions
/// @see Sobol, USSR Computational Mathematics and Mathematical Physics 7(4), 1967
[[nodiscard]] constexpr std::uint32_t sobol(std::uint32_t index, std::size_t dimension) {
    std::uint32_t bits = 0;
    for (const auto& contribution : sobol_tables[dimension]) {
        bits ^= contribution[index & 15];
        index >>= 4;
    }
    return bits;
}

}  // namespace sr
