#pragma once
/// @file spectrum.hpp

#include <cmath>

namespace sr {

/// Three numbers, one for each primary of linear sRGB: a colour, not a direction. A type of its own, so that
/// a radiance can't be normalised and a normal can't be tone-mapped.
struct Spectrum {
    float r = 0;
    float g = 0;
    float b = 0;

    friend constexpr Spectrum operator+(Spectrum s, Spectrum t) { return {s.r + t.r, s.g + t.g, s.b + t.b}; }
    friend constexpr Spectrum operator-(Spectrum s, Spectrum t) { return {s.r - t.r, s.g - t.g, s.b - t.b}; }
    friend constexpr Spectrum operator*(float k, Spectrum s) { return {k * s.r, k * s.g, k * s.b}; }
    friend constexpr Spectrum operator*(Spectrum s, float k) { return k * s; }
    friend constexpr Spectrum operator/(Spectrum s, float k) { return {s.r / k, s.g / k, s.b / k}; }
    friend constexpr Spectrum operator*(Spectrum s, Spectrum t) { return {s.r * t.r, s.g * t.g, s.b * t.b}; }
    friend constexpr bool     operator==(Spectrum, Spectrum) = default;
};

[[nodiscard]] constexpr float mean(Spectrum s) {
    return (s.r + s.g + s.b) / 3;
}

/// False where a channel is NaN.
[[nodiscard]] constexpr bool each_in(Spectrum s, float low, float high) {
    return s.r >= low && s.r <= high && s.g >= low && s.g <= high && s.b >= low && s.b <= high;
}

[[nodiscard]] inline bool is_finite(Spectrum s) {
    return std::isfinite(s.r) && std::isfinite(s.g) && std::isfinite(s.b);
}

}  // namespace sr
