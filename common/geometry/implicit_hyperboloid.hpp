#pragma once
/// @file implicit_hyperboloid.hpp

#include <cmath>
#include <concepts>

#include "geometry/box.hpp"
#include "math/square.hpp"
#include "math/vector.hpp"

namespace sr {

/// (x/a)^2 + (y/b)^2 - (z/c)^2 = 1, the hyperboloid of one sheet around the z axis, as far as |z| <= height. It is
/// curved everywhere, and yet through each of its points there are two straight lines in it.
/// @pre all semi-axes are positive, height >= 0
template <std::floating_point T>
struct Hyperboloid {
    Vector3<T> semi_axes;
    T          height;

    template <class Number>
    [[nodiscard]] auto f(const Number& x, const Number& y, const Number& z) const {
        return square(x / semi_axes.x) + square(y / semi_axes.y) - square(z / semi_axes.z) - T{1};
    }

    [[nodiscard]] Box<T> bounds() const {
        const T          wider = std::sqrt(1 + square(height / semi_axes.z));
        const Vector3<T> corner{semi_axes.x * wider, semi_axes.y * wider, height};
        return {-corner, corner};
    }
};

}  // namespace sr
