#pragma once
/// @file random_walk.hpp
/// What a point of a scene reflects, without any mesh.

#include <cstdint>
#include <vector>

#include "math/frame.hpp"
#include "radiosity/patch_view.hpp"
#include "radiosity/surface_samples.hpp"
#include "sampling/hemisphere.hpp"
#include "sampling/rng.hpp"
#include "statistics/running.hpp"

namespace sr {

/// One walk from a point: over directions drawn by their cosine from one surface to the next, until one absorbs it.
/// What lamps on its way emit is, on average, the point's green irradiance [W/m^2].
inline double walked(const SurfaceSample& from, const PatchView& view, const Patches& patches, Rng& rng) {
    double               emitted = 0;
    SurfacePoint<double> at      = patches.shapes[from.polygon].surface_point(from.position);
    for (;;) {
        const double u = rng.uniform<double>(), v = rng.uniform<double>();
        const auto   w    = frame_around(at.normal).to_world(sample_cosine_hemisphere(Vector2<double>{u, v}));
        const auto   seen = view.seen(leave(at, w));
        if (!seen) return emitted;
        emitted += patches.emission[seen->patch].g;
        if (!(rng.uniform<double>() < patches.reflectance[seen->patch].g)) return emitted;
        at = patches.shapes[seen->patch].surface_point(seen->position);
    }
}

/// The mean of many walks, the same for any number of threads.
inline Running mean_walk(const SurfaceSample& from, const PatchView& view, const Patches& patches, int walks,
                         int threads) {
    constexpr std::size_t blocks = 256;
    std::vector<Running>  of_block(blocks);
    for_each_row(blocks, {.threads = threads}, [&](std::size_t block) {
        Rng rng{1, std::int64_t(block), 0, 0};
        for (int i = 0; i < walks / int(blocks); ++i) of_block[block].add(walked(from, view, patches, rng));
    });
    Running all;
    for (const auto& part : of_block) all.merge(part);
    return all;
}

}  // namespace sr
