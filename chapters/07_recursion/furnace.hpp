#pragma once
/// @file furnace.hpp
/// Section 7.3: the inside of a sphere that is a mirror and shines, in which every depth has a known answer.

#include <fmt/format.h>

#include "course/chapter.hpp"
#include "transport/recursion.hpp"

namespace sr {

/// The radiance that a ray from inside sees, where the wall emits 1 and reflects rho, by rays k deep.
[[nodiscard]] inline double in_furnace(double rho, int k) {
    const auto share = float(rho);
    Scene      scene;
    scene.materials = {
        {"shining mirror", LobeSum<float>{{{{share, share, share}, Mirror<float>{}}}}, {1, 1, 1}}};
    scene.balls = {{{{0, 0, 0}, 1}, 0}};
    Rng      rng{1, 0, 0, 0};
    RayCount count;
    return double(
        RecursiveTracer(scene, {.depth = k}).radiance({{0.3F, 0.2F, 0.1F}, {1, 2, 3}}, rng, count).g);
}

/// The light that is missing at each depth, for mirrors of three reflectances.
inline void chart_furnace(course::Chart chart) {
    for (const double rho : {0.5, 0.8, 0.95}) {
        for (int k = 1; k <= 100; ++k) {
            const double missing = 100 * (1 - (1 - rho) * in_furnace(rho, k));
            if (missing >= 1e-3) chart.add(fmt::format("$\\rho = {}$", rho), k, missing);
        }
    }
}

/// The least depth at which no more than 1 % of the light is missing.
[[nodiscard]] inline int depth_for_99_percent(double rho) {
    int k = 1;
    while (!(in_furnace(rho, k) * (1 - rho) >= 0.99)) ++k;
    return k;
}

}  // namespace sr
