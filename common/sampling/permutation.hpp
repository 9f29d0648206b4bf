#pragma once
/// @file permutation.hpp

#include <algorithm>
#include <bit>
#include <cstdint>

#include "sampling/hash.hpp"

namespace sr {

/// Where a random permutation of 0, 1, ... n - 1 sends i, without a table: a bijection of as many bits as n - 1 has,
/// or of two, is repeated until it lands below n; of n >= 3 less than twice on average. Any two of the n go to any two
/// places, each as often: that is what variances need. (Of all orders, not each is as likely.)
/// @pre i < n, n >= 1
/// @see Kensler, Correlated Multi-Jittered Sampling (2013), whose bijection is another one
[[nodiscard]] constexpr std::uint32_t permuted(std::uint32_t i, std::uint32_t n, std::uint64_t seed) {
    const int           bits = std::max(int(std::bit_width(n - 1)), 2);
    const std::uint32_t mask = bits == 32 ? ~0U : (1U << bits) - 1;
    const int           half = bits / 2;
    do {
        // each round can be undone: by the odd factor's inverse, and from the top bits down
        for (int round = 0; round < 8; ++round) {
            const std::uint64_t key = scramble(seed + std::uint64_t(round));
            i                       = (i * (std::uint32_t(key) | 1) + std::uint32_t(key >> 32)) & mask;
            i ^= i >> half;
        }
    } while (i >= n);
    return i;
}

}  // namespace sr
