#pragma once
/// @file primary.hpp

#include <concepts>

#include "scene/camera.hpp"
#include "scene/visible.hpp"
#include "transport/tiles.hpp"

namespace sr {

/// What is seen through each pixel, one ray after the other.
/// @param  surfaces  anything with `nearest(Ray<T>)`: Hierarchy<T>, BruteForce<T>
template <std::floating_point T, class Surfaces>
[[nodiscard]] VisibilityImage<T> trace_primary(const Surfaces& surfaces, const Camera<T>& camera,
                                               const TileLoop& loop = {}) {
    VisibilityImage<T> image(camera.width, camera.height);
    for_each_pixel(camera.width, camera.height, loop, [&](int x, int y) {
        if (const auto hit = surfaces.nearest(camera.ray_through_pixel(x, y)))
            image(x, y) = {hit->t, hit->face};
    });
    return image;
}

}  // namespace sr
