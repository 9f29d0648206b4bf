#pragma once
/// @file zone_plate.hpp
/// Section 10.8: rings that get finer and finer, and what pixels make of them.

#include <cmath>
#include <cstdint>
#include <numbers>
#include <optional>

#include "image/image.hpp"
#include "radiometry/spectrum.hpp"
#include "sampling/sobol_point.hpp"
#include "transport/pixel_filter.hpp"
#include "transport/tiles.hpp"

namespace sr {

/// Rings about the lower left corner of a picture, (1 + cos(pi r^2 f / N)) / 2: at the distance r there are r f / N
/// waves in a pixel, and so f of them at the other end of each edge from there.
struct ZonePlate {
    int size;  ///< N, of the square picture [pixel]

    static constexpr double finest = 1.5;  ///< f [waves per pixel]

    /// @param at  point of the image [pixel], y downwards
    [[nodiscard]] double operator()(Vec2 at) const {
        const double x = double(at.x), y = double(size) - double(at.y);
        return 0.5 + 0.5 * std::cos(std::numbers::pi * finest / size * (x * x + y * y));
    }
};

/// What one pixel says of a pattern: the mean of so many samples, as its filter places them.
/// @param pattern  (Vec2 at) -> double
template <class Pattern>
[[nodiscard]] double seen_through(PixelFilter filter, int x, int y, std::uint32_t samples,
                                  const Pattern& pattern) {
    double sum = 0;
    for (std::uint32_t i = 0; i < samples; ++i) {
        SobolPoint point({.seed = 1008, .x = x, .y = y, .index = i, .count = samples});
        sum += pattern(Vec2{x, y} + sample_filter(filter, point.pair<float>()));
    }
    return sum / samples;
}

/// The rings through a filter; without one, as they are in the middle of each pixel.
[[nodiscard]] inline Image<Spectrum> zone_plate_through(std::optional<PixelFilter> filter, int size,
                                                        std::uint32_t samples, int threads) {
    const ZonePlate plate{size};
    Image<Spectrum> film(size, size);
    for_each_pixel(size, size, {.threads = threads}, [&](int x, int y) {
        const auto L = float(filter ? seen_through(*filter, x, y, samples, plate)
                                    : plate(Vec2{x, y} + Vec2{0.5F, 0.5F}));
        film(x, y)   = {L, L, L};
    });
    return film;
}

}  // namespace sr
