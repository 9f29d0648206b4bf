#pragma once
/// @file floor_under_ball.hpp

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>

#include "math/square.hpp"
#include "radiosity/rows.hpp"
#include "sampling/random_point.hpp"
#include "scene/small_scenes.hpp"
#include "statistics/estimate.hpp"
#include "statistics/running.hpp"
#include "transport/path_tracer.hpp"

namespace sr {

/// A white floor under a lamp that is a ball, by the half-angle at which it is seen straight above.
class FloorUnderBall {
public:
    explicit FloorUnderBall(double half_angle) {
        scene_.materials = {grey(1), grey(0, 1)};
        add_quad(scene_, {{{-50, -50, 0}, {50, -50, 0}, {50, 50, 0}, {-50, 50, 0}}}, 0);
        scene_.balls = {{{{0, 0, 2}, 2 * std::sin(half_angle)}, 1}};
    }

    /// The irradiance's variance of one path, pi^2 times that of the floor's radiance, and its standard error: 2^16
    /// paths in 16 blocks.
    [[nodiscard]] Estimate variance(Strategy strategy, std::uint64_t seed, int threads) const {
        const PathTracer        tracer(scene_, {.strategy = strategy, .bounces = 1});
        std::array<Running, 16> blocks;  // of the floor's radiance
        for_each_row(blocks.size(), {.threads = threads}, [&](std::size_t block) {
            PathCount count;
            for (std::uint32_t i = 0; i < 4096; ++i) {
                RandomPoint point(SampleId{.seed = seed, .x = std::int32_t(block), .index = i});
                blocks[block].add(double(tracer.radiance({{0.5F, 0, 0.5F}, {-1, 0, -1}}, point, count).g));
            }
        });
        Running variances;
        for (const Running& L : blocks) variances.add(square(std::numbers::pi) * L.variance());
        return {variances.mean(), variances.standard_error()};
    }

private:
    Scene scene_;
};

}  // namespace sr
