#pragma once
/// @file sobol_point.hpp

#include "sampling/owen.hpp"
#include "sampling/sample_point.hpp"
#include "sampling/sobol.hpp"
#include "sampling/unit_interval.hpp"

namespace sr {

/// Sobol's points with Owen's scrambling, in sets of four dimensions. Which points of one set and of the next go
/// together is random: in so many dimensions as a path has, Sobol's own pairings are bad until samples are very many.
/// Best where the number of samples is a power of 2.
/// @see Burley, Practical Hash-based Owen Scrambling, JCGT 9(4), 2020
class SobolPoint {
public:
    explicit SobolPoint(const SampleId& id) : sample_{id.index}, key_{id.pixel_key()} {}

    template <std::floating_point T>
    [[nodiscard]] T number() {
        const std::uint32_t in_set = dimension_++ % 4;
        if (in_set == 0) begin_set();
        const std::uint32_t bits =
            owen_scrambled(sobol(index_, in_set), std::uint32_t(scramble(set_ + in_set)));
        return to_unit_interval<T>(std::uint64_t{bits} << 32);
    }

    /// Both of one set.
    template <std::floating_point T>
    [[nodiscard]] Vector2<T> pair() {
        dimension_ += dimension_ % 2;
        return next_two<T>(*this);
    }

private:
    /// Owen's scrambling of an index lets points change places within blocks of 2^k, and blocks with others.
    void begin_set() {
        set_   = scramble(key_ + dimension_ / 4);
        index_ = owen_scrambled(sample_, std::uint32_t(set_ >> 32));
    }

    std::uint32_t sample_;
    std::uint64_t key_;
    std::uint32_t dimension_ = 0;
    std::uint64_t set_       = 0;
    std::uint32_t index_     = 0;
};

static_assert(SamplePoint<SobolPoint>);

}  // namespace sr
