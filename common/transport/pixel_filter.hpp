#pragma once
/// @file pixel_filter.hpp

#include <cmath>
#include <numbers>

#include "math/vector.hpp"

namespace sr {

/// What a pixel sees of the image plane, as a density about its middle: no sample has a weight, more of them lie
/// where the filter is larger. That needs a filter that is nowhere negative.
/// @see Ernst, Stamminger and Greiner, Filter Importance Sampling (2006)
enum class PixelFilter {
    box,       ///< the pixel and nothing else, evenly
    tent,      ///< linear from the middle to the neighbours' middles
    gaussian,  ///< of standard deviation 0.5 pixel, out to 2 pixels
};

/// One coordinate, in pixels from the middle.
/// @pre 0 <= u < 1
[[nodiscard]] inline float sample_tent(float u) {
    return u < 0.5F ? std::sqrt(2 * u) - 1 : 1 - std::sqrt(2 - 2 * u);
}

/// Where in the image a sample of the pixel with the corner (0, 0) lies [pixel].
/// @param u uniform in [0, 1)^2
[[nodiscard]] inline Vec2 sample_filter(PixelFilter filter, Vec2 u) {
    switch (filter) {
        case PixelFilter::box:
            return u;
        case PixelFilter::tent:
            return {0.5F + sample_tent(u.x), 0.5F + sample_tent(u.y)};
        case PixelFilter::gaussian: {
            constexpr float deviation = 0.5F, reach = 2;
            // Box and Muller's radius, of which what lies beyond the reach, e^-8, is left out
            const float     within = 1 - std::exp(-reach * reach / (2 * deviation * deviation));
            const float     r      = deviation * std::sqrt(-2 * std::log1p(-u.x * within));
            const float     phi    = 2 * std::numbers::pi_v<float> * u.y;
            return {0.5F + r * std::cos(phi), 0.5F + r * std::sin(phi)};
        }
    }
    return u;
}

}  // namespace sr
