#pragma once
/// @file random_point.hpp

#include "sampling/rng.hpp"
#include "sampling/sample_point.hpp"

namespace sr {

/// Coordinates that have nothing to do with each other or with those of other samples.
class RandomPoint {
public:
    explicit RandomPoint(const SampleId& id) : rng_{id.seed, id.x, id.y, id.index} {}

    template <std::floating_point T>
    [[nodiscard]] T number() {
        return rng_.uniform<T>();
    }

    template <std::floating_point T>
    [[nodiscard]] Vector2<T> pair() {
        return next_two<T>(*this);
    }

private:
    Rng rng_;
};

static_assert(SamplePoint<RandomPoint>);

}  // namespace sr
