#pragma once
/// @file rng.hpp

#include <concepts>
#include <cstdint>

#include "sampling/hash.hpp"
#include "sampling/unit_interval.hpp"

namespace sr {

/// PCG32 (pcg_setseq_64_xsh_rr_32): a sequence of period 2^64, one of 2^63 such streams.
/// @see O'Neill, PCG: A Family of Simple Fast Space-Efficient Statistically Good Algorithms for Random Number
///      Generation (2014)
class Rng {
public:
    /// The sequence of one sample of one pixel, whoever computes it and when: so a render is the same for any
    /// number of threads, and any of its samples can be replayed. The numbers are hashed, because a generator
    /// that is seeded with neighbouring numbers begins with similar ones.
    constexpr Rng(std::uint64_t seed, std::int64_t x, std::int64_t y, std::int64_t sample)
        : Rng(hash(seed, x, y, sample), scramble(~hash(seed, x, y, sample))) {}

    /// The sequence that O'Neill's pcg32_srandom_r(initial_state, stream) starts.
    constexpr Rng(std::uint64_t initial_state, std::uint64_t stream) : increment_{stream << 1 | 1} {
        next_u32();
        state_ += initial_state;
        next_u32();
    }

    /// All 2^32 values, each as likely.
    constexpr std::uint32_t next_u32() {
        const std::uint64_t old = state_;
        state_                  = old * 6364136223846793005 + increment_;
        const auto xorshifted   = std::uint32_t((old >> 18 ^ old) >> 27);
        const auto rotation     = std::uint32_t(old >> 59);
        return xorshifted >> rotation | xorshifted << (-rotation & 31);
    }

    /// A multiple of 2^-24 (float) or 2^-53 (double) in [0, 1).
    template <std::floating_point T = float>
    constexpr T uniform() {
        if constexpr (sizeof(T) == sizeof(float)) {
            return to_unit_interval<T>(std::uint64_t{next_u32()} << 32);
        } else {
            const std::uint64_t high = next_u32();
            const std::uint64_t low  = next_u32();
            return to_unit_interval<T>(high << 32 | low);
        }
    }

    friend constexpr bool operator==(const Rng&, const Rng&) = default;

private:
    std::uint64_t state_ = 0;
    std::uint64_t increment_;
};

}  // namespace sr
