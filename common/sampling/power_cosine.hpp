#pragma once
/// @file power_cosine.hpp
/// Directions about +z whose density falls as a power of the cosine, pdf(w) = (e + 1) / 2 pi cos^e; e = 1 is the
/// cosine hemisphere. A triple, as those of hemisphere.hpp.

#include <cmath>
#include <concepts>
#include <numbers>

#include "math/vector.hpp"
#include "sampling/hemisphere.hpp"
#include "sampling/pdf.hpp"

namespace sr {

/// cos = (1 - u.x)^(1 / (e + 1)), phi = 2 pi u.y. Its mean cosine is (e + 1) / (e + 2).
/// @param e  exponent, >= 0
/// @pre   0 <= u.x < 1 and 0 <= u.y < 1
/// @return unit length to rounding
template <std::floating_point T>
[[nodiscard]] Vector3<T> sample_power_cosine(Vector2<T> u, T e) {
    // 1 - cos, computed as such: in a narrow lobe it is all there is
    const T below = -std::expm1(std::log1p(-u.x) / (e + 1));
    const T r     = std::sqrt(below * (2 - below));
    const T phi   = 2 * std::numbers::pi_v<T> * u.y;
    return {r * std::cos(phi), r * std::sin(phi), 1 - below};
}

/// (e + 1) / 2 pi cos^e, and 0 below the horizon.
template <std::floating_point T>
[[nodiscard]] Pdf<measure::SolidAngle> pdf_power_cosine(const Vector3<T>& w, T e) {
    return {w.z > 0 ? (double(e) + 1) / (2 * std::numbers::pi) * std::pow(double(w.z), double(e)) : 0};
}

/// @pre w.z > 0
template <std::floating_point T>
[[nodiscard]] Vector2<T> invert_power_cosine(const Vector3<T>& w, T e) {
    return {-std::expm1((e + 1) * std::log(w.z)), turn(w)};
}

}  // namespace sr
