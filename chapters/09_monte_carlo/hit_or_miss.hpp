#pragma once
/// @file hit_or_miss.hpp

#include <cstdint>

#include "math/square.hpp"
#include "repeated.hpp"
#include "sampling/rng.hpp"
#include "statistics/running.hpp"

namespace sr {

/// Pi as 4 times the share of a square's points that lie in the quarter of a disk.
/// @param thousands  of points
[[nodiscard]] inline Running hit_or_miss(int thousands, int threads) {
    const auto parts = repeated(thousands, threads, [](std::uint64_t k) {
        Rng     rng{94, std::int64_t(k), 0, 0};
        Running part;
        for (int i = 0; i < 1000; ++i) {
            const double x = rng.uniform<double>(), y = rng.uniform<double>();
            part.add(square(x) + square(y) < 1 ? 4 : 0);
        }
        return part;
    });
    Running    mean;
    for (const Running& part : parts) mean.merge(part);
    return mean;
}

}  // namespace sr
