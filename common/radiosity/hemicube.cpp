/// @file hemicube.cpp

#include "radiosity/hemicube.hpp"

#include <fmt/format.h>

#include <numeric>
#include <stdexcept>

#include "geometry/offset.hpp"
#include "math/frame.hpp"
#include "math/square.hpp"
#include "scene/rasteriser.hpp"

namespace sr {

/// (8.12) at the pixels' middles, 1 / r^4 of one of the top and height / r^4 of one of a side; divided by their sum,
/// so that the whole sky is 1 at any resolution.
Hemicube::Hemicube(const Patches& patches, int resolution)
    : shapes_{patches.shapes}, seen_{mesh_of(patches)}, resolution_{resolution} {
    if (!(resolution >= 2 && resolution % 2 == 0))
        throw std::invalid_argument(
            fmt::format("the hemicube's resolution is {}; must be even and at least 2", resolution));
    const auto at = [&](int pixel) { return (2 * pixel + 1.0) / resolution - 1; };
    for (int j = 0; j < resolution; ++j)
        for (int i = 0; i < resolution; ++i) {
            const double weight = 1 / square(square(at(i)) + square(at(j)) + 1);
            top_.push_back(weight);
            if (j < resolution / 2)
                side_.push_back(-at(j) * weight);  // y points downwards: -at(j) is the height
        }
    const double sky =
        std::accumulate(top_.begin(), top_.end(), 0.0) + 4 * std::accumulate(side_.begin(), side_.end(), 0.0);
    for (double& weight : top_) weight /= sky;
    for (double& weight : side_) weight /= sky;
}

std::vector<double> Hemicube::row(std::size_t i) const {
    std::vector<double> row(shapes_.size());
    const Patch&        from  = shapes_[i];
    const auto          frame = frame_around(from.normal());
    const auto          eye   = off_surface(from.surface_point(from.centre()), from.normal());
    // The first `weights.size()` pixels of what is seen in one direction.
    const auto          look = [&](const Vector3<double>& forward, const Vector3<double>& up,
                          const std::vector<double>& weights) {
        const Camera<double> camera{eye,         cross(forward, up), up, forward, resolution_,
                                    resolution_, resolution_ / 2.0};
        const auto           image = rasterise(seen_.mesh, camera);
        for (std::size_t pixel = 0; pixel < weights.size(); ++pixel) {
            const int  x = int(pixel) % resolution_, y = int(pixel) / resolution_;
            const auto visible = image(x, y);
            if (!visible.hit()) continue;
            const std::size_t j = seen_.patch_of_face[visible.face];
            if (dot(camera.ray_through_pixel(x, y).direction, shapes_[j].normal()) < 0)
                row[j] += weights[pixel];
        }
    };
    look(frame.n, frame.s, top_);
    for (const auto& side : {frame.s, -frame.s, frame.t, -frame.t}) look(side, frame.n, side_);
    return row;
}

}  // namespace sr
