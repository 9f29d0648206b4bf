#pragma once
/// @file light_walk.hpp
/// How bright whole polygons are, without any mesh.

#include <cstdint>
#include <vector>

#include "math/frame.hpp"
#include "radiosity/patch_view.hpp"
#include "sampling/hemisphere.hpp"
#include "sampling/rng.hpp"
#include "statistics/running.hpp"
#include "told_to.hpp"

namespace sr {

/// One walk of green light from a lamp, in directions drawn by their cosine. `reflections` counts on which polygons
/// it went on.
inline void walk(const Patch& lamp, const PatchView& view, const Patches& polygons, Rng& rng,
                 std::vector<double>& reflections) {
    const double         s = rng.uniform<double>(), t = rng.uniform<double>();
    SurfacePoint<double> at = lamp.surface_point(lamp.sample({s, t}));
    // until a surface absorbs it or it leaves
    for (;;) {
        const double u = rng.uniform<double>(), v = rng.uniform<double>();
        const auto   w    = frame_around(at.normal).to_world(sample_cosine_hemisphere(Vector2<double>{u, v}));
        const auto   seen = view.seen(leave(at, w));
        if (!seen || !(rng.uniform<double>() < polygons.reflectance[seen->patch].g)) return;
        ++reflections[seen->patch];
        at = polygons.shapes[seen->patch].surface_point(seen->position);
    }
}

/// What each polygon reflects of its green light, B - E [W/m^2], by so many walks from the only lamp: what it emits
/// times the share of walks that went on there, over the polygon's area. The same for any number of threads.
inline std::vector<Running> walked(const Patches& polygons, std::size_t lamp, int walks, int threads) {
    constexpr int                    blocks = 256;
    const PatchView                  view(polygons);
    course::Progress                 progress("walking with the light", steps_of_loop);
    std::vector<std::vector<double>> reflections(blocks, std::vector<double>(polygons.size()));
    for_each_row(blocks, told_to(progress, threads), [&](std::size_t block) {
        Rng rng{1, std::int64_t(block), 0, 0};
        for (int i = 0; i < walks / blocks; ++i)
            walk(polygons.shapes[lamp], view, polygons, rng, reflections[block]);
    });
    const double         power = polygons.shapes[lamp].area() * polygons.emission[lamp].g;
    std::vector<Running> means(polygons.size());
    for (const auto& of_block : reflections)
        for (std::size_t i = 0; i < means.size(); ++i)
            means[i].add(of_block[i] * blocks / walks * power / polygons.shapes[i].area());
    return means;
}

}  // namespace sr
