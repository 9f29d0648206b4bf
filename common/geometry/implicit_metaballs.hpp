#pragma once
/// @file implicit_metaballs.hpp

#include <algorithm>
#include <cmath>
#include <concepts>
#include <vector>

#include "geometry/box.hpp"
#include "math/square.hpp"
#include "math/vector.hpp"

namespace sr {

/// Balls that flow into each other where they are near: each spreads a field (1 + |p - c|^2 / r^2)^-2, and the
/// surface is where their sum is `threshold`.
/// @pre radii are positive, 0 < threshold < number of balls
/// @see Blinn, A Generalization of Algebraic Surface Drawing, ACM TOG 1(3), 1982, who has exponentials for fields;
///      Sherstyuk, Kernel functions in convolution surfaces, The Visual Computer 15 (1999), for this one
template <std::floating_point T>
struct Metaballs {
    struct Ball {
        Vector3<T> centre;
        T          radius;
    };
    std::vector<Ball> balls;
    T                 threshold = T(0.5);

    template <class Number>
    requires requires(T k, Number n) { k / n; }  // which polynomials can't
    [[nodiscard]] Number f(const Number& x, const Number& y, const Number& z) const {
        Number outside = x * T{0} + threshold;  // a constant, of whatever type
        for (const auto& [c, r] : balls) {
            const Number far = (square(x - c.x) + square(y - c.y) + square(z - c.z)) / (r * r);
            outside          = outside - square(T{1} / (far + T{1}));
        }
        return outside;
    }

    /// Where all n fields are below threshold / n, their sum is below it.
    [[nodiscard]] Box<T> bounds() const {
        const T reach = std::sqrt(std::sqrt(T(balls.size()) / threshold) - 1);
        Box<T>  box;
        for (const auto& ball : balls) {
            box.include(ball.centre - Vector3<T>(reach * ball.radius));
            box.include(ball.centre + Vector3<T>(reach * ball.radius));
        }
        return box;
    }
};

}  // namespace sr
