#pragma once
/// @file sphere.hpp
/// A ray meets a sphere, from near, from far, from inside, and on the surface of one as large as a planet.

#include <concepts>
#include <optional>

#include "geometry/ray.hpp"
#include "math/difference_of_squares.hpp"
#include "math/interval.hpp"
#include "math/quadratic.hpp"
#include "math/vector.hpp"

namespace sr {

/// The points at the distance `radius` from the centre, [length unit].
template <std::floating_point T>
struct Sphere {
    Vector3<T> centre;
    T          radius;
};

/// Where the ray's line enters the sphere and where it leaves it, on either side of the ray's origin: the roots of
/// (2.4). The same t twice where it touches.
/// @param ray  direction of any length; t counts in units of |d|
/// @pre   radius > 0; the squares of |d|, of |o - c| and of the radius neither overflow nor underflow, nor do
///        their products (in float, lengths between 10^-9 and 10^9); what is not finite is missed
/// @see   Haines, Gunther & Akenine-Moeller, Precision Improvements for Ray/Sphere Intersection, Ray Tracing Gems
///        (2019), chapter 7: (2.5). Near the sphere their s^2 - r^2 has no digits left; (2.16) has.
template <std::floating_point T>
[[nodiscard]] std::optional<Roots<T>> crossings(const Sphere<T>& sphere, const Ray<T>& ray) {
    const Vector3<T> s = ray.origin - sphere.centre;
    const Vector3<T> d = ray.direction;
    const T          r = sphere.radius;
    const T          a = dot(d, d);
    const T          b = dot(s, d);

    // (2.16) near the sphere, s^2 and r^2 agree in many digits: their difference needs twice as many
    T c = dot(s, s) - r * r;
    if (!(c > r * r)) c = difference_of_squares(s, r);
    // From inside b^2 - a c is a sum of squares: the ray can't miss.
    if (c < 0) return quadratic_roots(a, b, c, b * b - a * c);

    // (2.5) how far the line passes from the centre: b^2 - a c would cancel at a distance
    const Vector3<T> foot  = s - (b / a) * d;
    const T          delta = r * r - dot(foot, foot);
    return quadratic_roots(a, b, c, a * delta);
}

/// Nearest t in `range` with |o + t d - c|^2 = r^2. From inside it is where the ray leaves.
/// @pre as `crossings`
template <std::floating_point T>
[[nodiscard]] std::optional<T> intersect(const Sphere<T>& sphere, const Ray<T>& ray,
                                         Interval<T> range = in_front<T>) {
    const auto roots = crossings(sphere, ray);
    return roots ? roots->first_in(range) : std::nullopt;
}

}  // namespace sr
