#pragma once
/// @file spectrum.hpp

namespace sr {

/// Three numbers, one for each primary of linear sRGB: a colour, not a direction. A type of its own, so that
/// a radiance can't be normalised and a normal can't be tone-mapped.
struct Spectrum {
    float r = 0;
    float g = 0;
    float b = 0;

    friend constexpr Spectrum operator+(Spectrum a, Spectrum b) { return {a.r + b.r, a.g + b.g, a.b + b.b}; }
    friend constexpr Spectrum operator*(Spectrum a, Spectrum b) { return {a.r * b.r, a.g * b.g, a.b * b.b}; }
    friend constexpr Spectrum operator*(float s, Spectrum a) { return {s * a.r, s * a.g, s * a.b}; }
    friend constexpr bool     operator==(Spectrum, Spectrum) = default;
};

}  // namespace sr
