#pragma once
/// @file sky.hpp
/// The irradiance of a facet that is tilted out of the horizontal, under a sky above and a black ground below.

#include <cmath>
#include <concepts>
#include <numbers>

#include "radiometry/emitters.hpp"
#include "radiometry/quantity.hpp"

namespace sr {

/// Under a sky of the same radiance everywhere: pi L (1 + cos(tilt)) / 2.
/// @param tilt  between the facet's normal and the zenith [rad], 0 to pi
/// @throws std::invalid_argument if the radiance is negative or not finite
/// @see   Liu and Jordan, The Long-Term Average Performance of Flat-Plate Solar-Energy Collectors (1963)
template <std::floating_point T>
[[nodiscard]] Irradiance<T> uniform_sky_irradiance(Radiance<T> L, T tilt) {
    require_light("radiance of the sky", L.value());
    return L * SolidAngle<T>{std::numbers::pi_v<T> * (1 + std::cos(tilt)) / 2};
}

/// Under the standard overcast sky L (1 + 2 cos(theta)) / 3, three times as bright at the zenith as at the horizon. The
/// part with the cosine, integrated over the directions that facet and sky share, is
/// (2/3) ((pi - tilt) cos(tilt) + sin(tilt)).
/// @param zenith  radiance at the zenith
/// @param tilt    as above
/// @throws std::invalid_argument if the radiance is negative or not finite
/// @see   Moon and Spencer, Illumination from a Non-Uniform Sky (1942); CIE standard S 011
template <std::floating_point T>
[[nodiscard]] Irradiance<T> overcast_sky_irradiance(Radiance<T> zenith, T tilt) {
    require_light("radiance of the sky", zenith.value());
    constexpr T pi     = std::numbers::pi_v<T>;
    const T     cosine = std::cos(tilt);
    const T     rising = T(4) / 3 * ((pi - tilt) * cosine + std::sin(tilt));
    return zenith * SolidAngle<T>{(pi * (1 + cosine) / 2 + rising) / 3};
}

}  // namespace sr
