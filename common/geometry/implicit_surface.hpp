#pragma once
/// @file implicit_surface.hpp
/// Surfaces that are an equation, f(x, y, z) = 0. Each is a struct with one formula, written for any number type:
/// of numbers it is the value, of dual numbers also the gradient, of intervals bounds of the value in a box, and of
/// polynomials in t the coefficients of f along a ray.
///
///     const Torus<float> torus{2, 0.5F};
///     if (const auto t = solve(torus, ray)) shade(normal(torus, ray.at(*t), ray.direction));

#include <algorithm>
#include <cmath>
#include <concepts>
#include <limits>
#include <optional>

#include "geometry/box.hpp"
#include "geometry/ray.hpp"
#include "math/dual.hpp"
#include "math/interval.hpp"
#include "math/interval_arithmetic.hpp"
#include "math/polynomial.hpp"

namespace sr {

/// A surface is where f is 0; f is negative inside. What lies outside its bounds is cut off: a surface that is moved
/// or scaled gives its bounds room for the rounding of both.
template <class Surface, class T>
concept ImplicitSurface = requires(const Surface surface, T x, Interval<T> range, Dual<Interval<T>, 1> dual) {
    { surface.f(x, x, x) } -> std::same_as<T>;
    { surface.f(range, range, range) } -> std::same_as<Interval<T>>;
    { surface.f(dual, dual, dual) } -> std::same_as<Dual<Interval<T>, 1>>;
    { surface.bounds() } -> std::same_as<Box<T>>;
};

/// f(o + t d), equation (2.1), for t of any number type.
template <class Surface, std::floating_point T, class Number>
[[nodiscard]] auto on_ray(const Surface& surface, const Ray<T>& ray, const Number& t) {
    const auto& o = ray.origin;
    const auto& d = ray.direction;
    return surface.f(t * d.x + o.x, t * d.y + o.y, t * d.z + o.z);
}

/// Bounds of f along a piece of the ray, and of its derivative df/dt there.
template <class Surface, std::floating_point T>
[[nodiscard]] Dual<Interval<T>, 1> bounds_on_ray(const Surface& surface, const Ray<T>& ray,
                                                 Interval<T> piece) {
    return on_ray(surface, ray, Dual<Interval<T>, 1>{piece, {{{1, 1}}}});
}

/// The part of `range` in which the ray is in the surface's bounds, and a little more: where the surface touches
/// them, a ray that came in by rounding's breadth too late would be inside already, and miss it. None where it
/// misses them, or where a coordinate that is not finite leaves no finite part.
/// @pre range.min >= 0
template <class Surface, std::floating_point T>
[[nodiscard]] std::optional<Interval<T>> within_bounds(const Surface& surface, const Ray<T>& ray,
                                                       Interval<T> range) {
    const Interval<T> part = BoxRay<T>(ray).clip(surface.bounds(), range);
    if (part.empty() || !std::isfinite(part.min) || !std::isfinite(part.max)) return std::nullopt;
    const T rounding = 8 * std::numeric_limits<T>::epsilon() * part.max;
    return Interval<T>{std::max(part.min - rounding, range.min), std::min(part.max + rounding, range.max)};
}

/// The gradient of f by dual numbers: as exact as one derived by hand.
template <class Surface, std::floating_point T>
[[nodiscard]] Vector3<T> gradient(const Surface& surface, Vector3<T> p) {
    using Number = Dual<T, 3>;
    const auto f = surface.f(Number::variable(p.x, 0), Number::variable(p.y, 1), Number::variable(p.z, 2));
    return {f.derivative[0], f.derivative[1], f.derivative[2]};
}

}  // namespace sr
