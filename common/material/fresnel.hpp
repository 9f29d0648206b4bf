#pragma once
/// @file fresnel.hpp

#include <cmath>
#include <concepts>

namespace sr {

/// How much of the light is reflected where two transparent media meet.
template <std::floating_point T>
struct Reflectance {
    T s;  ///< of light polarised across the plane of incidence
    T p;  ///< of light polarised in it

    /// Of unpolarised light, as a renderer has it.
    [[nodiscard]] constexpr T mean() const { return (s + p) / 2; }
};

/// Fresnel's equations for dielectrics; 1 where light is reflected totally.
/// @param cos_i  of the angle to the normal on the side that light comes from, 0 to 1
/// @param eta    index of refraction on the other side over that on this side, > 0
/// @see   Born and Wolf, Principles of Optics (1999), section 1.5.2
template <std::floating_point T>
[[nodiscard]] Reflectance<T> fresnel(T cos_i, T eta) {
    const T sin_i   = std::sqrt((1 - cos_i) * (1 + cos_i));
    const T squared = (eta - sin_i) * (eta + sin_i);
    if (!(squared > 0)) return {1, 1};
    const T a = std::sqrt(squared);  // eta cos(theta_t)
    const T s = (cos_i - a) / (cos_i + a);
    const T p = (eta * eta * cos_i - a) / (eta * eta * cos_i + a);
    return {s * s, p * p};
}

}  // namespace sr
