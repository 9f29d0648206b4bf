#pragma once
/// @file conductor.hpp

#include <cmath>
#include <complex>
#include <concepts>

#include "material/fresnel.hpp"

namespace sr {

/// Fresnel's equations for a metal, whose index of refraction is complex, n + i k: what goes in is absorbed.
/// @param cos_i  0 to 1
/// @param index  of the metal, over that of the medium that light comes from
/// @see   Born and Wolf, Principles of Optics (1999), section 14.2
template <std::floating_point T>
[[nodiscard]] Reflectance<T> fresnel(T cos_i, std::complex<T> index) {
    const std::complex<T> squared = index * index;
    const std::complex<T> a       = std::sqrt(squared - (1 - cos_i) * (1 + cos_i));
    const std::complex<T> s       = (cos_i - a) / (cos_i + a);
    const std::complex<T> p       = (squared * cos_i - a) / (squared * cos_i + a);
    return {std::norm(s), std::norm(p)};
}

}  // namespace sr
