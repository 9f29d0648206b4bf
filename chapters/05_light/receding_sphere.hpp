#pragma once
/// @file receding_sphere.hpp
/// A sphere that shines equally everywhere recedes from a camera: what becomes of its pixels, and of its irradiance?

#include <cmath>

#include "geometry/sphere.hpp"
#include "image/image.hpp"
#include "math/extremes.hpp"
#include "math/square.hpp"
#include "radiometry/solid_angle.hpp"
#include "radiometry/spectrum.hpp"
#include "sampled.hpp"
#include "scene/camera.hpp"
#include "transport/tiles.hpp"

namespace sr {

/// A camera in the origin that looks along z, at a unit sphere of radiance 1.
struct RecedingSphere {
    Camera<double> camera;
    int            side = 8;  ///< each pixel asks side^2 rays

    explicit RecedingSphere(int size)
        : camera{pinhole_camera<double>({0, 0, 0}, {0, 0, 1}, {0, 1, 0}, 2, 1, size, size)} {}

    /// One of the rays through a pixel, by its number: they form a square.
    [[nodiscard]] Ray<double> ray(int x, int y, int i) const {
        const int column = i % side, row = i / side;
        return camera.ray({x + (column + 0.5) / side, y + (row + 0.5) / side});
    }

    /// The radiance that the pixel receives, averaged over its rays.
    [[nodiscard]] double pixel(double distance, int x, int y) const {
        const Sphere<double> sphere{{0, 0, distance}, 1};
        int                  hits = 0;
        for (int i = 0; i < side * side; ++i) hits += intersect(sphere, ray(x, y, i)) ? 1 : 0;
        return double(hits) / (side * side);
    }

    /// The solid angle under which a pixel is seen from the pinhole, by (5.5), times the cosine at the pinhole: what its
    /// radiance counts for the irradiance there.
    [[nodiscard]] double projected_pixel(int x, int y) const {
        const auto   d      = camera.ray_through_pixel(x, y).direction;
        const double cosine = d.z / length(d);
        return cosine * solid_angle_per_area(cosine, Length<double>{length(d)}).value();
    }

    struct Seen {
        double brightest;   ///< pixel [W/(m^2 sr)]
        double irradiance;  ///< at the pinhole, summed over the pixels [W/m^2]
    };

    [[nodiscard]] Seen look(double distance, int threads) const {
        Image<double> radiance(camera.width, camera.height);
        for_each_pixel(camera.width, camera.height, {.threads = threads},
                       [&](int x, int y) { radiance(x, y) = pixel(distance, x, y); });
        Seen seen{0, 0};
        for (int y = 0; y < camera.height; ++y) {
            for (int x = 0; x < camera.width; ++x) {
                seen.brightest = max_or_nan(seen.brightest, radiance(x, y));
                seen.irradiance += radiance(x, y) * projected_pixel(x, y);
            }
        }
        return seen;
    }
};

/// The radiance of the globe in the picture where its normal is n: six bands.
[[nodiscard]] inline Spectrum globe_radiance(const Vector3<double>& n) {
    const auto band = int(std::floor(3 * (n.y + 1)));
    return band % 2 == 0 ? Spectrum{1, 0.75F, 0.3F} : Spectrum{0.85F, 0.3F, 0.06F};
}

/// The picture of such a sphere with bands, each of its own radiance, as a globe has lands and seas.
[[nodiscard]] inline Image<Spectrum> render_globe(double distance, int size, int threads) {
    const RecedingSphere globe(size);
    const Sphere<double> sphere{{0, 0, distance}, 1};
    Image<Spectrum>      film(size, size);
    for_each_pixel(size, size, {.threads = threads}, [&](int x, int y) {
        Spectrum sum;
        for (int i = 0; i < globe.side * globe.side; ++i) {
            const auto ray = globe.ray(x, y, i);
            const auto t   = intersect(sphere, ray);
            sum = sum + (t ? globe_radiance(ray.at(*t) - sphere.centre) : Spectrum{0.02F, 0.02F, 0.03F});
        }
        film(x, y) = sum / float(globe.side * globe.side);
    });
    return film;
}

}  // namespace sr
