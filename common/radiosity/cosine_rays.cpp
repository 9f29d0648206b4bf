/// @file cosine_rays.cpp

#include "radiosity/cosine_rays.hpp"

#include <cmath>

#include "geometry/offset.hpp"
#include "math/frame.hpp"
#include "sampling/hemisphere.hpp"
#include "sampling/stratum.hpp"

namespace sr {

CosineRays::CosineRays(const Patches& patches)
    : shapes_{patches.shapes}, seen_{mesh_of(patches)}, hierarchy_{seen_.mesh} {}

std::vector<double> CosineRays::row(std::size_t i, int side, Rng& rng) const {
    std::vector<double> row(shapes_.size());
    const Patch&        from  = shapes_[i];
    const auto          frame = frame_around(from.normal());
    const int           count = side * side;
    const double        shift = rng.uniform<double>();  // which direction goes with which point
    for (int k = 0; k < count; ++k) {
        const double x = rng.uniform<double>(), y = rng.uniform<double>();
        const double u = rng.uniform<double>(), v = rng.uniform<double>();
        const auto   p = from.sample(in_stratum(k, side, Vector2<double>{x, y}));
        const int    l =
            int(std::fmod(k * 0.61803398874989485 + shift, 1.0) * count) % count;  // far from k's neighbours'
        const auto w   = frame.to_world(sample_cosine_hemisphere(in_stratum(l, side, Vector2<double>{u, v})));
        const auto hit = hierarchy_.nearest(leave(from.surface_point(p), w));
        if (!hit) continue;
        const std::size_t j = seen_.patch_of_face[hit->face];
        if (dot(w, shapes_[j].normal()) < 0) row[j] += 1.0 / count;
    }
    return row;
}

}  // namespace sr
