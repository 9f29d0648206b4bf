#pragma once
/// @file emitters.hpp
/// The flux of the usual lamps, from what is known of them: the integral of radiance over area and projected solid
/// angle, or of intensity over directions.

#include <fmt/format.h>

#include <cmath>
#include <concepts>
#include <numbers>
#include <stdexcept>

#include "radiometry/quantity.hpp"
#include "radiometry/solid_angle.hpp"

namespace sr {

/// @throws std::invalid_argument naming the value unless it is at least 0 and finite
template <std::floating_point T>
void require_light(const char* what, T value) {
    if (!(value >= 0 && std::isfinite(value)))
        throw std::invalid_argument(fmt::format("{} is {}; must be 0 or more, and finite", what, value));
}

/// B = pi L [W/m^2], of what shines equally into all directions of a hemisphere: a Lambert emitter.
/// @throws std::invalid_argument if the radiance is negative or not finite
template <std::floating_point T>
[[nodiscard]] Radiosity<T> lambert_radiosity(Radiance<T> L) {
    require_light("radiance", L.value());
    return L * SolidAngle<T>{std::numbers::pi_v<T>};
}

/// pi L A [W], of a Lambert emitter of any shape of which no part shines at another: 4 pi^2 r^2 L for a sphere.
/// @throws std::invalid_argument if radiance or area are negative or not finite
template <std::floating_point T>
[[nodiscard]] Flux<T> lambert_flux(Radiance<T> L, Area<T> area) {
    require_light("area", area.value());
    return lambert_radiosity(L) * area;
}

/// 2 pi I (1 - cos a) [W], of a point that shines with intensity I within the angle a of an axis; 4 pi I with a = pi.
/// @throws std::invalid_argument if the intensity is negative or not finite, or the angle not from 0 to pi
template <std::floating_point T>
[[nodiscard]] Flux<T> cone_flux(Intensity<T> I, T half_angle) {
    require_light("intensity", I.value());
    if (!(half_angle >= 0 && half_angle <= std::numbers::pi_v<T>))
        throw std::invalid_argument(fmt::format("half-angle is {}; must be 0 to pi", half_angle));
    return I * cap_solid_angle(half_angle);
}

/// 2 pi I / (m + 1) [W], of a point whose intensity falls off as I cos^m about its axis.
/// @throws std::invalid_argument if the intensity or the exponent are negative or not finite
template <std::floating_point T>
[[nodiscard]] Flux<T> cosine_spot_flux(Intensity<T> axial, T exponent) {
    require_light("intensity", axial.value());
    require_light("exponent", exponent);
    return axial * SolidAngle<T>{2 * std::numbers::pi_v<T> / (exponent + 1)};
}

/// E = I cos(theta) / r^2 [W/m^2] of a point light; 0 from behind.
/// @param cosine    between the receiver's normal and the direction to the light
/// @throws std::invalid_argument if the intensity is negative or not finite
template <std::floating_point T>
[[nodiscard]] Irradiance<T> point_irradiance(Intensity<T> I, T cosine, Length<T> distance) {
    require_light("intensity", I.value());
    return I * solid_angle_per_area(cosine < 0 ? T{0} : cosine, distance);
}

}  // namespace sr
