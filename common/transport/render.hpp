#pragma once
/// @file render.hpp

#include <cmath>
#include <cstdint>
#include <limits>
#include <stdexcept>

#include "image/image.hpp"
#include "radiometry/spectrum.hpp"
#include "sampling/rng.hpp"
#include "scene/camera.hpp"
#include "transport/tiles.hpp"

namespace sr {

/// A sample that can't be: it says which, so that it can be computed again and looked at.
class BadSample : public std::runtime_error {
public:
    BadSample(int x, int y, int sample, Spectrum L);
};

/// How many rays a pixel has, and the seed of what is random in them.
struct PixelSampling {
    int samples        = 16;  ///< a square number: the rays pass through the middles of a grid in the pixel
    std::uint64_t seed = 1;
};

/// The side of the grid of so many samples.
/// @throws std::invalid_argument if the number is not a square
[[nodiscard]] int grid_side(int samples);

/// Each pixel's mean radiance. No sample that is negative or not finite is passed over in silence: the mean of a
/// pixel would be wrong, or the pixel, and after a blur its neighbours, NaN.
/// @param radiance  (Ray<float>, Rng&) -> Spectrum; Rng{seed, x, y, sample} is the sample's own
/// @throws BadSample
template <class Radiance>
[[nodiscard]] Image<Spectrum> render(const Camera<float>& camera, const PixelSampling& sampling,
                                     const TileLoop& loop, const Radiance& radiance) {
    const int       side = grid_side(sampling.samples);
    Image<Spectrum> film(camera.width, camera.height);
    for_each_pixel(camera.width, camera.height, loop, [&](int x, int y) {
        DoubleSpectrum sum;
        for (int sample = 0; sample < sampling.samples; ++sample) {
            const int      column = sample % side, row = sample / side;
            const Vec2     image{float(x) + (float(column) + 0.5F) / float(side),
                             float(y) + (float(row) + 0.5F) / float(side)};
            Rng            rng{sampling.seed, x, y, sample};
            const Spectrum L = radiance(camera.ray(image), rng);
            if (!each_in(L, 0, std::numeric_limits<float>::max())) throw BadSample(x, y, sample, L);
            sum = sum + convert<double>(L);
        }
        film(x, y) = convert<float>(sum / double(sampling.samples));
    });
    return film;
}

}  // namespace sr
