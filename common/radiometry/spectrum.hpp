#pragma once
/// @file spectrum.hpp

namespace sr {

/// Three numbers, one for each primary of linear sRGB: a colour, not a direction. A type of its own, so that
/// a radiance can't be normalised and a normal can't be tone-mapped.
struct Spectrum {
    float r = 0;
    float g = 0;
    float b = 0;

    friend constexpr Spectrum operator+(Spectrum s, Spectrum t) { return {s.r + t.r, s.g + t.g, s.b + t.b}; }
    friend constexpr Spectrum operator*(float k, Spectrum s) { return {k * s.r, k * s.g, k * s.b}; }
    friend constexpr bool     operator==(Spectrum, Spectrum) = default;
};

}  // namespace sr
