#pragma once
/// @file implicit_ellipsoid.hpp

#include <concepts>

#include "geometry/box.hpp"
#include "math/square.hpp"
#include "math/vector.hpp"

namespace sr {

/// (x/a)^2 + (y/b)^2 + (z/c)^2 = 1, around the origin.
/// @pre all semi-axes are positive
template <std::floating_point T>
struct Ellipsoid {
    Vector3<T> semi_axes;

    template <class Number>
    [[nodiscard]] auto f(const Number& x, const Number& y, const Number& z) const {
        return square(x / semi_axes.x) + square(y / semi_axes.y) + square(z / semi_axes.z) - T{1};
    }

    [[nodiscard]] Box<T> bounds() const { return {-semi_axes, semi_axes}; }
};

}  // namespace sr
