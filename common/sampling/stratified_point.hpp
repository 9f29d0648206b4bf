#pragma once
/// @file stratified_point.hpp

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "sampling/permutation.hpp"
#include "sampling/rng.hpp"
#include "sampling/sample_point.hpp"

namespace sr {

/// Of n samples of a pixel, each number lies at random in another n-th of [0, 1), and each pair in another square of
/// a grid of n. Which strata of one number and of the next go together is random: pairs of pairs are not stratified.
class StratifiedPoint {
public:
    /// @pre id.index < id.count
    explicit StratifiedPoint(const SampleId& id)
        : index_{id.index},
          count_{id.count},
          key_{id.pixel_key()},
          side_{std::uint32_t(std::lround(std::sqrt(id.count)))},
          rng_{id.seed, id.x, id.y, id.index} {}

    template <std::floating_point T>
    [[nodiscard]] T number() {
        return in_stratum<T>(next_stratum(), count_);
    }

    /// @throws std::invalid_argument if the count is no square number: a square has no strata of so many
    template <std::floating_point T>
    [[nodiscard]] Vector2<T> pair() {
        if (side_ * side_ != count_)
            throw std::invalid_argument(
                fmt::format("{} samples can't be stratified in pairs; must be a square number, "
                            "1, 4, 9, ...",
                            count_));
        const std::uint32_t k = next_stratum();
        const T             x = in_stratum<T>(k % side_, side_), y = in_stratum<T>(k / side_, side_);
        return {x, y};
    }

private:
    [[nodiscard]] std::uint32_t next_stratum() {
        return permuted(index_, count_, scramble(key_ + dimension_++));
    }

    template <std::floating_point T>
    [[nodiscard]] T in_stratum(std::uint32_t k, std::uint32_t n) {
        const T end = std::nextafter(T(k + 1) / T(n), T{0});  // the sum may be rounded up to the next stratum
        return std::min((T(k) + rng_.uniform<T>()) / T(n), end);
    }

    std::uint32_t index_, count_;
    std::uint64_t key_;
    std::uint32_t side_;
    std::uint32_t dimension_ = 0;
    Rng           rng_;
};

static_assert(SamplePoint<StratifiedPoint>);

}  // namespace sr
