#pragma once
/// @file offset.hpp
/// Where does a ray start that leaves a surface? The point that was hit is rounded, and lies on one side of the
/// surface or the other. It is moved along the normal, (2.18), by what rounding can have moved it and no more.
///
///     const SurfacePoint<float> p = surface_point(sphere, ray, t);
///     trace(leave(p, direction));                                   // from t = 0 on, without an epsilon
///     const bool lit = !hierarchy.occluded(between(p, on_the_light), before_the_end<float>);
///
/// For spheres, planes and triangles. For implicit surfaces, see implicit_offset.hpp.

#include <cmath>
#include <concepts>
#include <limits>

#include "geometry/plane.hpp"
#include "geometry/ray.hpp"
#include "geometry/sphere.hpp"
#include "geometry/triangle.hpp"
#include "math/interval.hpp"
#include "math/vector.hpp"

namespace sr {

/// A point on a surface as far as the type can tell, which ray.at(t) is not. `normal` has length one and does not
/// know where the ray came from: it is a sphere's outward one, a plane's own, that of a triangle's front.
template <std::floating_point T>
struct SurfacePoint {
    Vector3<T> position;
    Vector3<T> normal;
    T          error;  ///< the surface, as a ray from nearby meets it, is no farther away [length unit]
};

/// How far the roundings on the way to a point and from there to the next hit can add up, where the numbers on
/// the way are no larger than `size`. In each, one step is epsilon / 2 of its size; there are some ten of them,
/// the rest is margin: of a million rays, none needed more than a quarter of it, and a sixteenth was too little. Never
/// 0, nor so small that its products underflow.
template <std::floating_point T>
[[nodiscard]] T rounding_bound(T size) {
    using Limits = std::numeric_limits<T>;
    return 16 * Limits::epsilon() * size + Limits::min() / Limits::epsilon();
}

/// |x| + |y| + |z|: no less than the length, and without a square root.
template <std::floating_point T>
[[nodiscard]] T size_of(const Vector3<T>& v) {
    return std::abs(v.x) + std::abs(v.y) + std::abs(v.z);
}

/// The hit of a ray at t, moved to the sphere along its radius: that of a grazing ray is known to the square root
/// of the type's precision only.
/// @pre the centre is not hit
template <std::floating_point T>
[[nodiscard]] SurfacePoint<T> surface_point(const Sphere<T>& sphere, const Ray<T>& ray, T t) {
    const Vector3<T> n = normalize(ray.at(t) - sphere.centre);
    const Vector3<T> p = sphere.centre + sphere.radius * n;
    return {p, n, rounding_bound(sphere.radius + size_of(p))};
}

/// The hit of a ray at t, moved to the plane along its normal.
template <std::floating_point T>
[[nodiscard]] SurfacePoint<T> surface_point(const Plane<T>& plane, const Ray<T>& ray, T t) {
    const Vector3<T> n   = normalize(plane.normal);
    const Vector3<T> hit = ray.at(t);
    const Vector3<T> p   = hit + dot(n, plane.point - hit) * n;
    return {p, n, rounding_bound(size_of(p) + size_of(plane.point - p))};
}

/// The hit of a triangle as the weighted mean of its vertices: no farther from it than they are rounded, whatever
/// the distance from which it was hit.
/// @param normal  its front's, if it is known: the same as without
template <std::floating_point T>
[[nodiscard]] SurfacePoint<T> surface_point(const Triangle<T>& triangle, const Vector2<T>& uv,
                                            const Vector3<T>& normal) {
    const auto& [a, b, c] = triangle;
    const T u = uv.x, v = uv.y, w = 1 - u - v;
    return {w * a + u * b + v * c, normal, rounding_bound(w * size_of(a) + u * size_of(b) + v * size_of(c))};
}
template <std::floating_point T>
[[nodiscard]] SurfacePoint<T> surface_point(const Triangle<T>& triangle, const Vector2<T>& uv) {
    return surface_point(triangle, uv, normalize(area_vector(triangle)));
}

/// The point moved off its surface, to the side to which the direction points.
/// @pre the angle between direction and surface is more than rounding: to 8 epsilon, sides can't be told apart
template <std::floating_point T>
[[nodiscard]] Vector3<T> off_surface(const SurfacePoint<T>& from, const Vector3<T>& direction) {
    return from.position + std::copysign(from.error, dot(from.normal, direction)) * from.normal;
}

/// The ray from the point that does not meet the surface which it leaves, unless that bends back.
template <std::floating_point T>
[[nodiscard]] Ray<T> leave(const SurfacePoint<T>& from, const Vector3<T>& direction) {
    return {off_surface(from, direction), direction};
}

/// The range of a ray that ends at t = 1, without what rounding may find there.
template <std::floating_point T>
inline constexpr Interval<T> before_the_end{0, 1 - 16 * std::numeric_limits<T>::epsilon()};

/// The ray that leaves one surface at t = 0 and arrives at a point in space at t = 1.
template <std::floating_point T>
[[nodiscard]] Ray<T> between(const SurfacePoint<T>& from, const Vector3<T>& to) {
    const Vector3<T> origin = off_surface(from, to - from.position);
    return {origin, to - origin};
}

/// The ray that leaves one surface at t = 0 and arrives at another at t = 1: in `before_the_end` it meets what is
/// between them, and neither of the two.
template <std::floating_point T>
[[nodiscard]] Ray<T> between(const SurfacePoint<T>& from, SurfacePoint<T> to) {
    const Vector3<T> back = from.position - to.position;
    to.error += rounding_bound(size_of(back));  // the far end of a ray is known to its length's digits
    return between(from, off_surface(to, back));
}

}  // namespace sr
