#pragma once
/// @file squared_sphere.hpp

#include "geometry/box.hpp"
#include "math/square.hpp"

namespace sr {

/// (x^2 + y^2 + z^2 - 1)^2 = 0: the unit sphere's points, every one of them a double root.
struct SquaredSphere {
    template <class Number>
    [[nodiscard]] auto f(const Number& x, const Number& y, const Number& z) const {
        return square(square(x) + square(y) + square(z) - 1.0);
    }
    [[nodiscard]] Box<double> bounds() const { return {Vector3<double>(-4), Vector3<double>(4)}; }
};

}  // namespace sr
