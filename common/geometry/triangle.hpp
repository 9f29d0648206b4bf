#pragma once
/// @file triangle.hpp
/// A ray meets a triangle, in such a way that no ray slips between two triangles that share an edge.
///
///     const TriangleRay<float> seen(ray);  // once for all triangles
///     if (const auto hit = seen.intersect(triangle)) shade(surface_point(triangle, hit->uv));

#include <algorithm>
#include <cmath>
#include <concepts>
#include <glm/gtc/type_ptr.hpp>
#include <limits>
#include <optional>

#include "geometry/ray.hpp"
#include "math/difference_of_products.hpp"
#include "math/interval.hpp"
#include "math/vector.hpp"

namespace sr {

/// Three points; the front is where they run counter-clockwise.
template <std::floating_point T>
struct Triangle {
    Vector3<T> a, b, c;
};

/// The vector along the front's normal whose length is twice the area, [length unit^2].
template <std::floating_point T>
[[nodiscard]] Vector3<T> area_vector(const Triangle<T>& triangle) {
    return cross(triangle.b - triangle.a, triangle.c - triangle.a);
}

/// [length unit^2]
template <std::floating_point T>
[[nodiscard]] T area(const Triangle<T>& triangle) {
    return length(area_vector(triangle)) / 2;
}

/// Where a ray meets a triangle: r(t), which is (1 - u - v) a + u b + v c.
template <std::floating_point T>
struct Hit {
    T          t;
    Vector2<T> uv;
};

/// A ray made ready for many triangles: its direction's largest component becomes the third axis, and the
/// triangles are seen along the ray, so that the question becomes a plane one: is the origin in a triangle?
/// @pre no product of three coordinates overflows (10^12 in float): a hit where one does may be lost. A ray or a
///      triangle that is not finite has none
template <std::floating_point T>
class TriangleRay {
public:
    explicit TriangleRay(const Ray<T>& ray) {
        const Vector3<T> d = glm::abs(ray.direction);
        z_axis_            = d.x > d.y ? (d.x > d.z ? 0 : 2) : (d.y > d.z ? 1 : 2);
        x_axis_            = (z_axis_ + 1) % 3;
        y_axis_            = (z_axis_ + 2) % 3;
        origin_            = {ray.origin[x_axis_], ray.origin[y_axis_], ray.origin[z_axis_]};
        // A power of two changes no digit, and keeps the products of a very long direction from overflowing. That
        // of the shortest directions would overflow itself.
        int exponent = 0;
        std::frexp(ray.direction[z_axis_], &exponent);
        scale_ = std::ldexp(T{1}, -std::max(exponent, std::numeric_limits<T>::min_exponent));
        direction_ =
            scale_ * Vector3<T>{ray.direction[x_axis_], ray.direction[y_axis_], ray.direction[z_axis_]};
    }

    /// The nearest hit is `Hit::t` in units of the ray's own direction, on either side of the triangle.
    ///
    /// Of two triangles that share an edge, the edge function of one is exactly minus that of the other: they
    /// can't both decide that a ray is beyond it. A ray exactly on an edge hits both. Triangles that are
    /// seen edge-on, or have no area, are missed. All comparisons are written so that NaN misses.
    /// @see Woop, Benthin & Wald, Watertight Ray/Triangle Intersection, JCGT 2(1), 2013. They compute the edge
    ///      functions plainly and repeat them in double where one is zero; here Kahan's difference of products
    ///      gives the weights their digits at once, and in any precision.
    [[nodiscard]] std::optional<Hit<T>> intersect(const Triangle<T>& triangle,
                                                  Interval<T>        range = in_front<T>) const {
        const Seen a = seen(triangle.a);
        const Seen b = seen(triangle.b);
        const Seen c = seen(triangle.c);
        const T    u = difference_of_products(c.x, b.y, c.y, b.x);
        const T    v = difference_of_products(a.x, c.y, a.y, c.x);
        const T    w = difference_of_products(b.x, a.y, b.y, a.x);

        const bool front = u >= 0 && v >= 0 && w >= 0;
        const bool back  = u <= 0 && v <= 0 && w <= 0;
        const T    sum   = u + v + w;
        if (!(front || back) || sum == 0 || !std::isfinite(sum)) return std::nullopt;

        // The hit's depth is between the vertices' depths: weights of one sign, no cancellation.
        const T t = (u * a.z + v * b.z + w * c.z) / (sum * direction_.z) * scale_;
        if (!range.contains(t)) return std::nullopt;
        return Hit<T>{t, {v / sum, w / sum}};
    }

private:
    struct Seen {
        T x, y, z;
    };

    /// A vertex as seen along the ray, which is the z axis.
    [[nodiscard]] Seen seen(const Vector3<T>& vertex) const {
        const T* coordinate = glm::value_ptr(vertex);  // GLM's own operator[] branches on the index
        const T  x          = coordinate[x_axis_] - origin_.x;
        const T  y          = coordinate[y_axis_] - origin_.y;
        const T  z          = coordinate[z_axis_] - origin_.z;
        return {difference_of_products(x, direction_.z, z, direction_.x),
                difference_of_products(y, direction_.z, z, direction_.y), z};
    }

    int        x_axis_, y_axis_, z_axis_;
    Vector3<T> origin_;
    Vector3<T> direction_;
    T          scale_;
};

}  // namespace sr
