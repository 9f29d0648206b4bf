#pragma once
/// @file aimed_at_boxes.hpp
/// Rays aimed at a place of a small box, and how many that hit it are lost to rounding.

#include <array>
#include <atomic>
#include <cstdint>

#include "sampling/rng.hpp"
#include "textbook_slabs.hpp"
#include "transport/tiles.hpp"

namespace sr {

enum class Aim { corner, edge, interior };

/// A box, and a ray towards it.
struct AimedRay {
    Ray<float> ray;
    Box<float> box;
};

/// A box at coordinates up to 10, its sides at most `size`, and a ray from a point of the same space.
[[nodiscard]] inline AimedRay aimed_at_box(Aim aim, double size, Rng& rng) {
    const auto uniform = [&](double low, double high) { return low + (high - low) * rng.uniform<double>(); };
    AimedRay   result;
    Vec3       target;
    const int  free_axis = int(uniform(0, 3));  // along an edge
    for (int axis = 0; axis < 3; ++axis) {
        result.ray.origin[axis] = float(uniform(-10, 10));
        result.box.min[axis]    = float(uniform(-10, 10));
        result.box.max[axis]    = float(result.box.min[axis] + uniform(0, size));
        const double between    = uniform(0, 1);
        const bool   free       = aim == Aim::interior || (aim == Aim::edge && axis == free_axis);
        const double share      = free ? between : between < 0.5 ? 0 : 1;
        target[axis] =
            float(result.box.min[axis] + share * (double(result.box.max[axis]) - result.box.min[axis]));
    }
    result.ray.direction = target - result.ray.origin;
    return result;
}

/// Whether the ray meets the box, by arithmetic with 11 more bits, or 29 where long double is double.
[[nodiscard]] inline bool truly_hits(const AimedRay& aimed) {
    using Exact = long double;
    const Ray<Exact> ray{Vector3<Exact>(aimed.ray.origin), Vector3<Exact>(aimed.ray.direction)};
    const Box<Exact> box{Vector3<Exact>(aimed.box.min), Vector3<Exact>(aimed.box.max)};
    return !padded_clip<Exact>(ray, box, 1).empty();
}

/// The share of true hits that a test in float misses [%].
/// @param hits  whether the test says so: bool(const Ray<float>&, const Box<float>&)
template <class Test>
[[nodiscard]] double percent_lost(Aim aim, double size, int rays, std::uint64_t seed, int threads,
                                  Test hits) {
    constexpr int    blocks = 64;
    std::atomic<int> truly = 0, lost = 0;
    for_each_pixel(blocks, blocks, {.threads = threads}, [&](int x, int y) {
        Rng rng{seed, x, y, 0};
        for (int i = 0; i < rays / (blocks * blocks); ++i) {
            const AimedRay aimed = aimed_at_box(aim, size, rng);
            if (!truly_hits(aimed)) continue;
            ++truly;
            if (!hits(aimed.ray, aimed.box)) ++lost;
        }
    });
    return 100.0 * lost / truly;
}

}  // namespace sr
