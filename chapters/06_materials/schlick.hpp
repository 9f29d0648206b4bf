#pragma once
/// @file schlick.hpp

#include <cmath>
#include <concepts>

namespace sr {

/// Schlick's approximation of the Fresnel reflectance with the cosine on the side that light comes from: right only
/// where that is the rarer medium.
/// @see Schlick, An Inexpensive BRDF Model for Physically-based Rendering (1994)
template <std::floating_point T>
[[nodiscard]] T textbook_schlick(T cos_i, T eta) {
    const T r = (eta - 1) / (eta + 1), R0 = r * r;
    return R0 + (1 - R0) * std::pow(1 - cos_i, T{5});
}

/// The same with the cosine on the rarer side, and 1 where light is reflected totally.
/// @param cos_i  0 to 1
/// @param eta    index of refraction on the other side over that on this side, > 0
/// @see   de Greve, Reflections and Refractions in Ray Tracing (2006)
template <std::floating_point T>
[[nodiscard]] T schlick(T cos_i, T eta) {
    if (eta >= 1) return textbook_schlick(cos_i, eta);
    const T sin_i   = std::sqrt((1 - cos_i) * (1 + cos_i));
    const T squared = (eta - sin_i) * (eta + sin_i);  // eta^2 cos^2(theta_t)
    return squared > 0 ? textbook_schlick(std::sqrt(squared) / eta, eta) : T{1};
}

}  // namespace sr
