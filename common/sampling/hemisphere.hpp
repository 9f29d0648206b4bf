#pragma once
/// @file hemisphere.hpp

#include <cmath>
#include <numbers>

#include "math/vector.hpp"

namespace sr {

/// A direction of the hemisphere about +z with pdf(w) = cos(theta) / pi [1/sr]: uniform in the unit disk, by
/// polar coordinates r = sqrt(u.x), phi = 2 pi u.y, then lifted to the sphere (Malley's method).
/// @pre    0 <= u.x < 1 and 0 <= u.y < 1; so z >= 2^-12, and dividing by the pdf is safe
/// @return unit length to rounding
[[nodiscard]] inline Vec3 sample_cosine_hemisphere(Vec2 u) {
    const float r   = std::sqrt(u.x);
    const float phi = 2 * std::numbers::pi_v<float> * u.y;
    return {r * std::cos(phi), r * std::sin(phi), std::sqrt(1 - u.x)};
}

}  // namespace sr
