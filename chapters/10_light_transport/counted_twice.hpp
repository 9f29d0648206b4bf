#pragma once
/// @file counted_twice.hpp
/// Section 10.2: light that is asked for at each surface, and also counts where it is met by chance.

#include <cstdint>

#include "course/claims.hpp"
#include "sampling/random_point.hpp"
#include "scene/small_scenes.hpp"
#include "statistics/estimate.hpp"
#include "statistics/running.hpp"
#include "transport/path_tracer.hpp"

namespace sr {

/// The radiance inside a ball of radiance 1 that reflects the share rho, by 2^14 paths.
[[nodiscard]] inline Estimate radiance_in_ball(float rho, Strategy strategy, std::uint64_t seed) {
    const PathTracer tracer(inside_of_a_ball(rho, 1), {.strategy = strategy});
    PathCount        count;
    Running          L;
    for (std::uint32_t i = 0; i < 1U << 14; ++i) {
        RandomPoint point(SampleId{.seed = seed, .index = i});
        L.add(double(tracer.radiance({{0.1F, 0.2F, 0}, {0, 0, 1}}, point, count).g));
    }
    return {L.mean(), L.standard_error()};
}

/// What a program gives that asks and meets: all of both, and once what the camera sees directly, which nobody asks
/// for. Tolerances are four standard errors.
inline void claim_counted_twice(course::Chapter& chapter) {
    const course::Claims claim{chapter, "10.2"};
    const auto           asked = radiance_in_ball(0.5F, Strategy::light, 1);
    const auto           met   = radiance_in_ball(0.5F, Strategy::bsdf, 2);
    claim("a ball of 0.5: radiance by its light", 2, asked.value, 4 * asked.error);
    claim("a ball of 0.5: radiance, if light counts twice", 3, asked.value + met.value - 1,
          4 * (asked.error + met.error));
}

}  // namespace sr
