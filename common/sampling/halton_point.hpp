#pragma once
/// @file halton_point.hpp

#include "sampling/halton.hpp"
#include "sampling/sample_point.hpp"
#include "sampling/unit_interval.hpp"

namespace sr {

/// Halton's points, moved, with what leaves the cube at one side let in at the other, by a vector of the pixel's own:
/// without it all pixels would have the same error.
/// @see Cranley and Patterson, Randomization of Number Theoretic Methods for Multiple Integration (1976)
class HaltonPoint {
public:
    explicit HaltonPoint(const SampleId& id) : index_{id.index}, key_{id.pixel_key()} {}

    /// After as many numbers as there are primes in the table, the first one's is used again, moved otherwise.
    template <std::floating_point T>
    [[nodiscard]] T number() {
        const std::uint32_t d = dimension_++;
        const double        moved =
            halton(index_, d % halton_dimensions) + to_unit_interval<double>(scramble(key_ + d));
        const auto bits = std::uint64_t((moved >= 1 ? moved - 1 : moved) * 0x1p53) << 11;
        return to_unit_interval<T>(bits);
    }

    template <std::floating_point T>
    [[nodiscard]] Vector2<T> pair() {
        return next_two<T>(*this);
    }

private:
    std::uint32_t index_;
    std::uint64_t key_;
    std::uint32_t dimension_ = 0;
};

static_assert(SamplePoint<HaltonPoint>);

}  // namespace sr
