#pragma once
/// @file squeezed_paths.hpp
/// Section 10.4: light in glass is squeezed by n^2 and not lost; roulette that knows that, and roulette that doesn't.

#include <algorithm>
#include <utility>

#include "course/claims.hpp"
#include "material/dielectric.hpp"
#include "sampling/hemisphere.hpp"
#include "sampling/rng.hpp"
#include "statistics/running.hpp"

namespace sr {

/// By what a path's chance of going on is taken for what is left of its light.
enum class Survival {
    by_light,       ///< throughput, n^2 of refraction aside
    by_throughput,  ///< as it is
};

/// What one path brings that meets a ball of glass under a sky of radiance 1: it is reflected, or goes in and leaves
/// after any number of reflections within. It is 1, for the sky is as bright in any direction; 0 if roulette ends it.
[[nodiscard]] inline double through_glass(const Dielectric<double>& glass, Survival survival, Rng& rng) {
    const double    u = rng.uniform<double>(), v = rng.uniform<double>();
    Vector3<double> wo         = sample_cosine_hemisphere(Vector2<double>{u, v});
    double          throughput = 1, squeezed = 1;
    while (true) {
        const auto sample = glass.sample(wo, {rng.uniform<double>(), 0}, TransportMode::radiance);
        throughput *= sample->weight;
        squeezed *= sample->squeezed;
        const double q = std::min(1.0, survival == Survival::by_light ? throughput / squeezed : throughput);
        if (!(rng.uniform<double>() < q)) return 0;
        throughput /= q;
        if (sample->wi.z > 0) return throughput;
        wo = sample->wi;  // chords of a ball meet it at the same angle at both ends, from within
    }
}

/// Of 2^18 paths: the share that roulette ended, and the variance. Without roulette both are 0.
inline void claim_squeezed(course::Chapter& chapter) {
    const course::Claims     claim{chapter, "10.4"};
    constexpr int            paths = 1 << 18;
    const Dielectric<double> glass(1.5);
    const auto               run = [&](Survival survival) {
        Rng     rng{106, 0, 0, 0};
        Running light, ended;
        for (int i = 0; i < paths; ++i) {
            const double L = through_glass(glass, survival, rng);
            light.add(L);
            ended.add(L > 0 ? 0 : 1);
        }
        return std::pair{light, ended};
    };
    const auto [naive, naive_ended] = run(Survival::by_throughput);
    const auto [light, ended]       = run(Survival::by_light);
    // 0.908 of a uniform sky's light goes into glass, and of it 1 / n^2 = 4 / 9 lives on, as 9 / 4 each
    claim("glass, roulette by throughput: paths that end [%]", 50.4, 100 * naive_ended.mean(), 0.4);
    claim("glass, roulette by throughput: mean", 1, naive.mean(), 4 * naive.standard_error());
    claim("glass, roulette by throughput: variance of a path", 1.13, naive.variance(), 0.012);
    claim("glass, roulette by light: paths that end [%]", 0, 100 * ended.mean(), 0);
    chapter.claim_at_most("10.4 glass, roulette by light: variance of a path", light.variance(), 1e-12);
}

}  // namespace sr
