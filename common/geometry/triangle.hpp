#pragma once
/// @file triangle.hpp
/// A ray meets a triangle, in such a way that no ray slips between two triangles that share an edge.
///
///     const TriangleRay<float> seen(ray);  // once for all triangles
///     if (const auto hit = seen.intersect(triangle)) shade(surface_point(triangle, hit->uv));

#include <algorithm>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <glm/gtc/type_ptr.hpp>
#include <limits>
#include <optional>

#include "geometry/ray.hpp"
#include "math/difference_of_products.hpp"
#include "math/interval.hpp"
#include "math/power_of_two.hpp"
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

/// As many triangles as can be asked at once, coordinate by coordinate: at first none, which is not hit.
template <std::floating_point T>
struct TrianglePack {
    static constexpr std::size_t lanes = 8;

    TrianglePack() { std::fill_n(&corners[0][0][0], 9 * lanes, std::numeric_limits<T>::quiet_NaN()); }

    alignas(32) T corners[3][3][lanes];  ///< of which corner, on which axis, of which triangle

    void set(std::size_t lane, const Triangle<T>& triangle) {
        const auto& [a, b, c] = triangle;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            corners[0][axis][lane] = glm::value_ptr(a)[axis];
            corners[1][axis][lane] = glm::value_ptr(b)[axis];
            corners[2][axis][lane] = glm::value_ptr(c)[axis];
        }
    }
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
        x_axis_            = z_axis_ == 2 ? 0 : z_axis_ + 1;
        y_axis_            = x_axis_ == 2 ? 0 : x_axis_ + 1;
        const T* o         = glm::value_ptr(ray.origin);  // GLM's own operator[] branches on the index
        const T* direction = glm::value_ptr(ray.direction);
        origin_            = {o[x_axis_], o[y_axis_], o[z_axis_]};
        // A power of two changes no digit, and keeps the products of a very long direction from overflowing. That
        // of the shortest directions would overflow itself.
        scale_     = 1 / std::max(power_of_two_in(direction[z_axis_]), std::numeric_limits<T>::min());
        direction_ = scale_ * Vector3<T>{direction[x_axis_], direction[y_axis_], direction[z_axis_]};
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
        const Weights weights =
            weigh(seen(glm::value_ptr(triangle.a), 1), seen(glm::value_ptr(triangle.b), 1),
                  seen(glm::value_ptr(triangle.c), 1));
        if (!inside(weights) || !range.contains(weights.t)) return std::nullopt;
        return Hit<T>{weights.t, {weights.v / weights.sum, weights.w / weights.sum}};
    }

    /// Calls take(lane, t) for each triangle of a pack, with infinity where the ray does not meet it in the range.
    /// Nothing in it branches: what `take` does for eight lanes, a processor can do at once if that does not either.
    template <class Take>
    void each_lane(const TrianglePack<T>& pack, Interval<T> range, const Take& take) const {
        for (std::size_t lane = 0; lane < pack.lanes; ++lane) {
            const auto    corner = [&](std::size_t k) { return seen(&pack.corners[k][0][lane], pack.lanes); };
            const Weights weights = weigh(corner(0), corner(1), corner(2));
            const bool    in      = (weights.t >= range.min) & (weights.t <= range.max);
            take(lane, (inside(weights) & in) ? weights.t : std::numeric_limits<T>::infinity());
        }
    }

private:
    struct Seen {
        T x, y, z;
    };
    /// How much each corner counts where the ray meets the triangle's plane, times their sum.
    struct Weights {
        T u, v, w, sum, t;
    };

    /// A vertex as seen along the ray, which is the z axis.
    /// @param coordinate  x, and y and z so many numbers further on
    [[nodiscard]] Seen seen(const T* coordinate, std::size_t stride) const {
        const T x = coordinate[x_axis_ * stride] - origin_.x;
        const T y = coordinate[y_axis_ * stride] - origin_.y;
        const T z = coordinate[z_axis_ * stride] - origin_.z;
        return {difference_of_products(x, direction_.z, z, direction_.x),
                difference_of_products(y, direction_.z, z, direction_.y), z};
    }

    [[nodiscard]] Weights weigh(const Seen& a, const Seen& b, const Seen& c) const {
        const T u   = difference_of_products(c.x, b.y, c.y, b.x);
        const T v   = difference_of_products(a.x, c.y, a.y, c.x);
        const T w   = difference_of_products(b.x, a.y, b.y, a.x);
        const T sum = u + v + w;
        // The hit's depth is between the vertices' depths: weights of one sign, no cancellation.
        return {u, v, w, sum, (u * a.z + v * b.z + w * c.z) / (sum * direction_.z) * scale_};
    }

    /// Without a branch, so that a processor can answer for eight triangles at once. No sum of a finite triangle's
    /// weights is infinite but by overflow.
    [[nodiscard]] static bool inside(const Weights& weights) {
        const auto [u, v, w, sum, t] = weights;
        const bool front = (u >= 0) & (v >= 0) & (w >= 0), back = (u <= 0) & (v <= 0) & (w <= 0);
        return (front | back) & (sum != 0) & (std::abs(sum) <= std::numeric_limits<T>::max());
    }

    std::size_t x_axis_, y_axis_, z_axis_;
    Vector3<T>  origin_;
    Vector3<T>  direction_;
    T           scale_;
};

}  // namespace sr
