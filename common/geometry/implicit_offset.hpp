#pragma once
/// @file implicit_offset.hpp
/// Where does a ray start that leaves an implicit surface? What offset.hpp says of spheres, planes and triangles:
///
///     if (const auto t = solve(torus, ray)) {
///         const SurfacePoint<float> p = surface_point(torus, ray, *t);
///         trace(leave(p, direction));
///     }

#include <concepts>

#include "geometry/box.hpp"
#include "geometry/implicit_normal.hpp"
#include "geometry/implicit_surface.hpp"
#include "geometry/offset.hpp"
#include "math/interval_arithmetic.hpp"
#include "math/vector.hpp"

namespace sr {

/// The largest |f| that rounding can make of f at p, where coordinates are known to +- `rounding` each.
template <class Surface, std::floating_point T>
[[nodiscard]] T largest_value(const Surface& surface, const Vector3<T>& p, T rounding) {
    const auto around = [=](T x) { return Interval<T>{x - rounding, x + rounding}; };
    return magnitude(surface.f(around(p.x), around(p.y), around(p.z)));
}

/// The hit of a ray at t, moved to the surface by a step of Newton's along the gradient, equation (2.19). What the
/// step has left and what rounding makes of f are both in the error: twice the largest |f| there over |grad f|.
///
/// It is a bound where f along the normal changes at no less than half the rate |grad f|, as far as it reaches.
/// It grows where the gradient vanishes, towards a cone's apex, and promises nothing where it is as large as what it
/// leads to. At the apex it is no number, and no ray from there meets anything.
/// @pre the hit is nearer to the surface than the surface's radii of curvature
template <std::floating_point T, ImplicitSurface<T> Surface>
[[nodiscard]] SurfacePoint<T> surface_point(const Surface& surface, const Ray<T>& ray, T t) {
    const Vector3<T> hit  = ray.at(t);
    const T          step = surface.f(hit.x, hit.y, hit.z) / length(gradient(surface, hit));
    const Vector3<T> p    = hit - step * normal(surface, hit, ray.direction);
    // A search reckons with coordinates as large as the bounds.
    const T          rounding = rounding_bound(size_of(p) + size_of(surface.bounds().size()));
    const T          distance = largest_value(surface, p, rounding) / length(gradient(surface, p));
    return {p, normal(surface, p, ray.direction), rounding + 2 * distance};
}

}  // namespace sr
