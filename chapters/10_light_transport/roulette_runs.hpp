#pragma once
/// @file roulette_runs.hpp
/// Section 10.4: many paths of a furnace, and what they show of their variance and cost.

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "math/square.hpp"
#include "roulette_furnace.hpp"
#include "statistics/estimate.hpp"
#include "statistics/running.hpp"
#include "transport/tiles.hpp"

namespace sr {

/// What 2^18 paths show, each with its standard error.
struct RouletteRun {
    static constexpr int paths = 1 << 18;

    Estimate light, variance, surfaces;
    Estimate cost;  ///< variance times surfaces, in squared means
};

[[nodiscard]] inline Estimate estimate_of(const Running& running) {
    return {running.mean(), running.standard_error()};
}

/// The variance's error is that of its mean over 64 blocks of paths: to be trusted where q > rho^(4/3), beyond which
/// the fourth moment is infinite. The same to the bit for any number of threads.
/// @param noise  what else is random in a path, as roulette_cost: here a coin adds it to the light or takes it away
[[nodiscard]] inline RouletteRun run_roulette(const RouletteFurnace& furnace, int threads, double noise = 0) {
    struct Block {
        Running light, surfaces;
    };
    std::array<Block, 64> blocks;
    const double          side = std::sqrt(noise) * furnace.mean();
    for_each_pixel(int(blocks.size()), 1, {.threads = threads}, [&](int x, int) {
        auto& block = blocks[std::size_t(x)];
        Rng   rng{104, x, 0, 0};
        for (std::size_t i = 0; i < RouletteRun::paths / blocks.size(); ++i) {
            const auto path = furnace.draw(rng);
            const bool head = noise > 0 && rng.uniform<double>() < 0.5;
            block.light.add(path.light + (head ? side : -side));
            block.surfaces.add(path.surfaces);
        }
    });
    Running light, variances, surfaces, costs;
    for (const auto& block : blocks) {
        light.merge(block.light);
        surfaces.merge(block.surfaces);
        variances.add(block.light.variance());
        costs.add(block.light.variance() * block.surfaces.mean() / square(furnace.mean()));
    }
    return {estimate_of(light), estimate_of(variances), estimate_of(surfaces), estimate_of(costs)};
}

}  // namespace sr
