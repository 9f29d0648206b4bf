#pragma once
/// @file moments.hpp

#include <cstdint>

#include "math/vector.hpp"
#include "repeated.hpp"
#include "sampling/rng.hpp"
#include "statistics/estimate.hpp"
#include "statistics/running.hpp"

namespace sr {

/// Two numbers in [0, 1).
[[nodiscard]] inline Vector2<double> draw_pair(Rng& rng) {
    const double x = rng.uniform<double>(), y = rng.uniform<double>();
    return {x, y};
}

/// Mean and variance of what is drawn, each with its standard error.
struct Moments {
    Estimate mean, variance;
};

/// Those of 2^18 numbers. The variance's error is that of its mean over 64 blocks.
/// @param stream  those of different ones are independent
/// @param draw    (Rng&) -> double; called from several threads
template <class Draw>
[[nodiscard]] Moments moments_of(std::uint64_t stream, const Draw& draw, int threads = 1) {
    const auto blocks = repeated(64, threads, [&](std::uint64_t block) {
        Rng     rng{stream, std::int64_t(block), 0, 0};
        Running part;
        for (int i = 0; i < 4096; ++i) part.add(draw(rng));
        return part;
    });
    Running    all, variances;
    for (const Running& block : blocks) {
        all.merge(block);
        variances.add(block.variance());
    }
    return {{all.mean(), all.standard_error()}, {variances.mean(), variances.standard_error()}};
}

}  // namespace sr
