#pragma once
/// @file textbook.hpp
/// Scattering as books write it, which is right until a cosine is negative or 0.

#include <cmath>
#include <concepts>
#include <numbers>

#include "material/reflect.hpp"
#include "math/vector.hpp"
#include "sampling/hemisphere.hpp"

namespace sr {

/// Phong's lobe (r.wi)^e without a clamp: for r.wi < 0 it is light from behind the lobe, negative, or NaN.
template <std::floating_point T>
[[nodiscard]] T textbook_phong(const Vector3<T>& wo, const Vector3<T>& wi, T e) {
    return std::pow(dot(reflect(wo), wi), e);
}

/// What a mirror reflects of L = 1, its delta evaluated: (rho / cos) cos.
template <std::floating_point T>
[[nodiscard]] T textbook_mirror_light(T rho, T cos_theta) {
    return rho / cos_theta * cos_theta;
}

/// The same in polar coordinates, (rho / sin) sin of the solid angle sin d(theta) d(phi).
template <std::floating_point T>
[[nodiscard]] T textbook_polar_mirror_light(T rho, T sin_theta) {
    return rho / sin_theta * sin_theta;
}

/// f cos / pdf of a diffuse surface, each computed, though all but rho cancels.
template <std::floating_point T>
[[nodiscard]] T textbook_diffuse_weight(T rho, Vector2<T> u) {
    const Vector3<T> wi = sample_cosine_hemisphere(u);
    return rho / std::numbers::pi_v<T> * wi.z / T(pdf_cosine_hemisphere(wi).value);
}

}  // namespace sr
