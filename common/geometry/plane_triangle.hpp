#pragma once
/// @file plane_triangle.hpp
/// A ray meets a triangle by way of its plane: all that belongs to the triangle alone is computed beforehand.

#include <concepts>
#include <optional>

#include "geometry/ray.hpp"
#include "geometry/triangle.hpp"
#include "math/interval.hpp"
#include "math/vector.hpp"

namespace sr {

/// A triangle made ready for many rays: its plane, and the two edge functions that are 0 along an edge and 1 at
/// the vertex opposite, equation (3.7). One without area is missed.
///
/// The point in the plane is rounded for each triangle by itself: a ray at an edge that two triangles share may
/// miss both. TriangleRay does not leak.
/// @see Badouel, An Efficient Ray-Polygon Intersection, Graphics Gems (1990)
template <std::floating_point T>
class PlaneTriangle {
public:
    explicit PlaneTriangle(const Triangle<T>& triangle) : a_{triangle.a}, normal_{area_vector(triangle)} {
        // (3.7) gradients of the edge functions: b1 = 1 at b, 0 along ca; b2 = 1 at c, 0 along ab
        const T normal2 = dot(normal_, normal_);
        gradient1_      = cross(triangle.c - triangle.a, normal_) / normal2;
        gradient2_      = cross(normal_, triangle.b - triangle.a) / normal2;
    }

    /// Where in `range` the ray meets the triangle, from either side.
    [[nodiscard]] std::optional<Hit<T>> intersect(const Ray<T>& ray, Interval<T> range) const {
        // (3.6) the plane first, then on which side of the edges its point is
        const Vector3<T> s = ray.origin - a_;
        const T          t = -dot(normal_, s) / dot(normal_, ray.direction);
        if (!range.contains(t)) return std::nullopt;
        const Vector3<T> p  = s + t * ray.direction;
        const T          b1 = dot(gradient1_, p), b2 = dot(gradient2_, p);

        if (!(b1 >= 0 && b2 >= 0 && b1 + b2 <= 1)) return std::nullopt;
        return Hit<T>{t, {b1, b2}};
    }

private:
    Vector3<T> a_, normal_, gradient1_, gradient2_;
};

}  // namespace sr
