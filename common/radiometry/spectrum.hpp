#pragma once
/// @file spectrum.hpp

#include <cmath>
#include <concepts>
#include <type_traits>

#include "math/extremes.hpp"

namespace sr {

/// Three numbers, one for each primary of linear sRGB: a colour, not a direction. A type of its own, so that
/// a radiance can't be normalised and a normal can't be tone-mapped. All operators act on each primary by itself.
template <std::floating_point T>
struct BasicSpectrum {
    T r = 0;
    T g = 0;
    T b = 0;

    friend constexpr BasicSpectrum operator+(BasicSpectrum s, BasicSpectrum t) {
        return {s.r + t.r, s.g + t.g, s.b + t.b};
    }
    friend constexpr BasicSpectrum operator-(BasicSpectrum s, BasicSpectrum t) {
        return {s.r - t.r, s.g - t.g, s.b - t.b};
    }
    friend constexpr BasicSpectrum operator*(T k, BasicSpectrum s) { return {k * s.r, k * s.g, k * s.b}; }
    friend constexpr BasicSpectrum operator*(BasicSpectrum s, T k) { return k * s; }
    friend constexpr BasicSpectrum operator/(BasicSpectrum s, T k) { return {s.r / k, s.g / k, s.b / k}; }
    friend constexpr BasicSpectrum operator*(BasicSpectrum s, BasicSpectrum t) {
        return {s.r * t.r, s.g * t.g, s.b * t.b};
    }
    friend constexpr BasicSpectrum operator/(BasicSpectrum s, BasicSpectrum t) {
        return {s.r / t.r, s.g / t.g, s.b / t.b};
    }
    friend constexpr bool operator==(BasicSpectrum, BasicSpectrum) = default;
};

/// What pictures are made of, and materials.
using Spectrum = BasicSpectrum<float>;

/// What long sums are made of.
using DoubleSpectrum = BasicSpectrum<double>;

template <std::floating_point T>
[[nodiscard]] constexpr T mean(BasicSpectrum<T> s) {
    return (s.r + s.g + s.b) / 3;
}

/// How far each number is from 0.
template <std::floating_point T>
[[nodiscard]] BasicSpectrum<T> magnitude(BasicSpectrum<T> s) {
    return {std::abs(s.r), std::abs(s.g), std::abs(s.b)};
}

/// The number of the primary that has most; NaN if one of them is NaN.
template <std::floating_point T>
[[nodiscard]] T largest(BasicSpectrum<T> s) {
    return max_or_nan(max_or_nan(s.r, s.g), s.b);
}

/// The same colour in another precision.
template <std::floating_point To, std::floating_point From>
[[nodiscard]] constexpr BasicSpectrum<To> convert(BasicSpectrum<From> s) {
    return {To(s.r), To(s.g), To(s.b)};
}

/// False where a channel is NaN.
template <std::floating_point T>
[[nodiscard]] constexpr bool each_in(BasicSpectrum<T> s, std::type_identity_t<T> low,
                                     std::type_identity_t<T> high) {
    return s.r >= low && s.r <= high && s.g >= low && s.g <= high && s.b >= low && s.b <= high;
}

template <std::floating_point T>
[[nodiscard]] bool is_finite(BasicSpectrum<T> s) {
    return std::isfinite(s.r) && std::isfinite(s.g) && std::isfinite(s.b);
}

}  // namespace sr
