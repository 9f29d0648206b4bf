#pragma once
/// @file rng.hpp

#include <concepts>
#include <cstdint>

namespace sr {

/// A step of splitmix64: a bijection of 64 bits in which each bit of the input turns over half of the
/// output's.
/// @see Steele, Lea and Flood, Fast Splittable Pseudorandom Number Generators (2014)
[[nodiscard]] constexpr std::uint64_t scramble(std::uint64_t value) {
    value += 0x9e3779b97f4a7c15;
    value = (value ^ (value >> 30)) * 0xbf58476d1ce4e5b9;
    value = (value ^ (value >> 27)) * 0x94d049bb133111eb;
    return value ^ (value >> 31);
}

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

    /// A multiple of 2^-24 (float) or 2^-53 (double) in [0, 1). Never 1: the bits that the type can't hold
    /// are dropped, where x * 2^-32 would round the largest x up.
    template <std::floating_point T = float>
    constexpr T uniform() {
        if constexpr (sizeof(T) == sizeof(float)) {
            return T(next_u32() >> 8) * T{0x1p-24};
        } else {
            const std::uint64_t high = next_u32();
            const std::uint64_t low  = next_u32();
            return T((high << 32 | low) >> 11) * T{0x1p-53};
        }
    }

    friend constexpr bool operator==(const Rng&, const Rng&) = default;

private:
    static constexpr std::uint64_t hash(std::uint64_t seed, std::int64_t x, std::int64_t y,
                                        std::int64_t sample) {
        std::uint64_t h = scramble(seed);
        h               = scramble(h ^ std::uint64_t(x));
        h               = scramble(h ^ std::uint64_t(y));
        return scramble(h ^ std::uint64_t(sample));
    }

    std::uint64_t state_ = 0;
    std::uint64_t increment_;
};

}  // namespace sr
