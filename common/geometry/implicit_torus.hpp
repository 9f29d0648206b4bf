#pragma once
/// @file implicit_torus.hpp

#include <concepts>

#include "geometry/box.hpp"
#include "math/square.hpp"
#include "math/vector.hpp"

namespace sr {

/// A ring around the z axis, a tube of radius `tube` around a circle of radius `ring`, equation (2.10):
/// (x^2 + y^2 + z^2 + R^2 - r^2)^2 = 4 R^2 (x^2 + y^2).
/// @pre 0 < tube < ring
/// @see implicit_surface.hpp: how a ray finds it
template <std::floating_point T>
struct Torus {
    T ring;  ///< R
    T tube;  ///< r

    /// For every type of number.
    template <class Number>
    [[nodiscard]] auto f(const Number& x, const Number& y, const Number& z) const {
        const auto from_axis = square(x) + square(y);
        return square(from_axis + square(z) + (ring - tube) * (ring + tube)) - from_axis * (4 * ring * ring);
    }

    [[nodiscard]] Box<T> bounds() const {
        const Vector3<T> corner{ring + tube, ring + tube, tube};
        return {-corner, corner};
    }
};

}  // namespace sr
