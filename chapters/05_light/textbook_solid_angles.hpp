#pragma once
/// @file textbook_solid_angles.hpp
/// Solid angles as they are derived, and what becomes of them in numbers.

#include <algorithm>
#include <cmath>
#include <concepts>
#include <numbers>
#include <set>

#include "geometry/triangle.hpp"
#include "math/square.hpp"
#include "math/vector.hpp"
#include "sampling/rng.hpp"
#include "statistics/running.hpp"

namespace sr {

/// A sphere's, 2 pi (1 - cos a) with sin a = r/d, equation (5.6): the cosine of a small angle is rounded to 1.
template <std::floating_point T>
[[nodiscard]] T textbook_sphere_solid_angle(T r, T d) {
    const T cosine = std::sqrt(1 - square(r / d));
    return 2 * std::numbers::pi_v<T> * (1 - cosine);
}

/// A triangle's, by Girard: the sum of its angles on the sphere, less pi.
template <std::floating_point T>
[[nodiscard]] T girard_solid_angle(const Triangle<T>& triangle) {
    const auto angle = [](const Vector3<T>& at, const Vector3<T>& p, const Vector3<T>& q) {
        const T cosine = dot(normalize(cross(at, p)), normalize(cross(at, q)));
        return std::acos(std::clamp(cosine, T{-1}, T{1}));
    };
    const auto& [a, b, c] = triangle;
    return angle(a, b, c) + angle(b, c, a) + angle(c, a, b) - std::numbers::pi_v<T>;
}

/// A triangle's, equation (5.8) with the quotient that is printed there.
template <std::floating_point T>
[[nodiscard]] T textbook_triangle_solid_angle(const Triangle<T>& triangle) {
    const auto& [a, b, c] = triangle;
    const T la = length(a), lb = length(b), lc = length(c);
    return 2 *
           std::atan(dot(a, cross(b, c)) / (la * lb * lc + dot(a, b) * lc + dot(a, c) * lb + dot(b, c) * la));
}

/// A direction in the cone of the half-angle with sine s: cos = 1 - u (1 - cos a), equation (5.9).
template <std::floating_point T>
[[nodiscard]] Vector3<T> textbook_cone(Vector2<T> u, T s) {
    const T z   = 1 - u.x * (1 - std::sqrt(1 - s * s));
    const T r   = std::sqrt(1 - z * z);
    const T phi = 2 * std::numbers::pi_v<T> * u.y;
    return {r * std::cos(phi), r * std::sin(phi), z};
}

/// What is left of a cone's directions, along one radius of its cap: how many distances from the axis there are, and
/// the mean square of that distance relative to the s^2 / 2 of a small disk.
struct ConeDraws {
    double distinct;
    double spread;
    double spread_se;
};

template <class Sample>
[[nodiscard]] ConeDraws draw_cone(float s, int draws, const Sample& sample) {
    Rng             rng{1, 0, 0, 0};
    std::set<float> distances;
    Running         spread;
    for (int i = 0; i < draws; ++i) {
        const float x = sample(Vec2{rng.uniform(), 0}, s).x;
        distances.insert(x);
        spread.add(square(double(x) / double(s)) * 2);
    }
    return {double(distances.size()), spread.mean(), spread.standard_error()};
}

}  // namespace sr
