#pragma once
/// @file philox.hpp

#include <array>
#include <concepts>
#include <cstdint>

#include "sampling/unit_interval.hpp"

namespace sr {

/// Philox4x32-10: four random words that depend on a counter and a key, and on nothing else. All 2^128 counters of a
/// key have different words. Nothing is kept from one call to the next: any number of any stream is as near as its
/// first.
/// @see Salmon, Moraes, Dror and Shaw, Parallel Random Numbers: As Easy as 1, 2, 3 (SC 2011)
[[nodiscard]] constexpr std::array<std::uint32_t, 4> philox(std::array<std::uint32_t, 4> counter,
                                                            std::array<std::uint32_t, 2> key) {
    auto& [a, b, c, d] = counter;
    for (int round = 0; round < 10; ++round) {
        const std::uint64_t p = std::uint64_t{0xd2511f53} * a, q = std::uint64_t{0xcd9e8d57} * c;
        counter = {std::uint32_t(q >> 32) ^ b ^ key[0], std::uint32_t(q), std::uint32_t(p >> 32) ^ d ^ key[1],
                   std::uint32_t(p)};
        key[0] += 0x9e3779b9;
        key[1] += 0xbb67ae85;
    }
    return counter;
}

/// The numbers of one sample of one pixel by their place: number(7) is the same whatever was drawn before.
class CounterRng {
public:
    constexpr CounterRng(std::uint64_t seed, std::int32_t x, std::int32_t y, std::int32_t sample)
        : key_{std::uint32_t(seed), std::uint32_t(seed >> 32)},
          stream_{std::uint32_t(x), std::uint32_t(y), std::uint32_t(sample)} {}

    /// The i-th number of the stream, uniform in [0, 1).
    template <std::floating_point T>
    [[nodiscard]] constexpr T number(std::uint32_t i) const {
        const auto words = philox({i, stream_[0], stream_[1], stream_[2]}, key_);
        return to_unit_interval<T>(std::uint64_t{words[0]} << 32 | words[1]);
    }

    /// The next one.
    template <std::floating_point T = float>
    constexpr T uniform() {
        return number<T>(next_++);
    }

private:
    std::array<std::uint32_t, 2> key_;
    std::array<std::uint32_t, 3> stream_;
    std::uint32_t                next_ = 0;
};

}  // namespace sr
