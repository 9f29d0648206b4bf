#pragma once
/// @file checker.hpp

#include <cmath>
#include <concepts>

#include "math/vector.hpp"
#include "radiometry/spectrum.hpp"

namespace sr {

/// A reflectance that depends on position: any function from the coordinates of a surface to a Spectrum is a texture,
/// and what it says at a hit is the weight of a lobe there. This one is a board of two colours.
struct Checker {
    Spectrum even;
    Spectrum odd;

    /// The colour of a square of side 1, by whether its coordinates add up to an even number.
    template <std::floating_point T>
    [[nodiscard]] Spectrum operator()(Vector2<T> p) const {
        const T squares = std::floor(p.x) + std::floor(p.y);
        return squares == 2 * std::floor(squares / 2) ? even : odd;
    }
};

}  // namespace sr
