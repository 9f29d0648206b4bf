#pragma once
/// @file two_lamps.hpp

#include <array>

#include "math/square.hpp"
#include "sampling/choice.hpp"
#include "sampling/rng.hpp"

namespace sr {

/// What two lamps give, 9 and 1, of which one is asked, chosen with a probability and divided by it.
struct TwoLamps {
    static constexpr std::array<double, 2> gives{9, 1};

    double chance;  ///< of the first, more than 0 and less than 1

    [[nodiscard]] double draw(Rng& rng) const {
        const std::array<double, 2> chances{chance, 1 - chance};
        const auto                  one = choose(
                             chances, [](double p) { return p; }, rng.uniform<double>());
        return gives[one->index] / one->chance;
    }

    /// Of one draw, exactly.
    [[nodiscard]] double variance() const {
        return square(gives[0]) / chance + square(gives[1]) / (1 - chance) - square(gives[0] + gives[1]);
    }
};

}  // namespace sr
