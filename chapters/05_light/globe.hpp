#pragma once
/// @file globe.hpp
/// Pictures of a sphere that recedes from a camera.

#include <cmath>

#include "geometry/sphere.hpp"
#include "image/image.hpp"
#include "radiometry/spectrum.hpp"
#include "scene/camera.hpp"
#include "transport/tiles.hpp"

namespace sr {

/// The radiance of the globe where its normal is n: six bands.
[[nodiscard]] inline Spectrum globe_radiance(const Vector3<double>& n) {
    const auto band = int(std::floor(3 * (n.y + 1)));
    return band % 2 == 0 ? Spectrum{1, 0.75F, 0.3F} : Spectrum{0.85F, 0.3F, 0.06F};
}

/// The picture of a unit sphere with bands, each of its own radiance, as a globe has lands and seas.
/// @param distance  from the pinhole to its centre [radii]
[[nodiscard]] inline Image<Spectrum> render_globe(double distance, int size, int threads) {
    constexpr int        side   = 8;  // each pixel asks side^2 rays, which form a square
    const auto           camera = pinhole_camera<double>({0, 0, 0}, {0, 0, 1}, {0, 1, 0}, 2, 1, size, size);
    const Sphere<double> sphere{{0, 0, distance}, 1};
    Image<Spectrum>      film(size, size);
    for_each_pixel(size, size, {.threads = threads}, [&](int x, int y) {
        Spectrum sum;
        for (int i = 0; i < side * side; ++i) {
            const int  column = i % side, row = i / side;
            const auto ray = camera.ray({x + (column + 0.5) / side, y + (row + 0.5) / side});
            const auto t   = intersect(sphere, ray);
            sum = sum + (t ? globe_radiance(ray.at(*t) - sphere.centre) : Spectrum{0.02F, 0.02F, 0.03F});
        }
        film(x, y) = sum / float(side * side);
    });
    return film;
}

}  // namespace sr
