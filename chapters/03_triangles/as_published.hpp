#pragma once
/// @file as_published.hpp
/// The watertight test as its inventors wrote it down, to be compared with TriangleRay.

#include <concepts>
#include <glm/gtc/type_ptr.hpp>
#include <optional>

#include "geometry/triangle.hpp"

namespace sr {

/// As TriangleRay, but the shear is a quotient, and the edge functions are plain differences of products, repeated in
/// double where one of them is 0. In double there is nothing to repeat them in.
/// @see Woop, Benthin & Wald, Watertight Ray/Triangle Intersection, JCGT 2(1), 2013
template <std::floating_point T>
class PublishedRay {
public:
    explicit PublishedRay(const Ray<T>& ray) : origin_{ray.origin} {
        const Vector3<T> d = glm::abs(ray.direction);
        z_                 = d.x > d.y ? (d.x > d.z ? 0 : 2) : (d.y > d.z ? 1 : 2);
        x_                 = (z_ + 1) % 3;
        y_                 = (z_ + 2) % 3;
        shear_             = Vector3<T>{ray.direction[x_], ray.direction[y_], 1} / ray.direction[z_];
    }

    [[nodiscard]] std::optional<Hit<T>> intersect(const Triangle<T>& triangle, Interval<T> range) const {
        const Vector3<T> a = seen(triangle.a), b = seen(triangle.b), c = seen(triangle.c);
        T                u = edge<T>(c, b), v = edge<T>(a, c), w = edge<T>(b, a);
        if (u == 0 || v == 0 || w == 0) {
            u = T(edge<double>(c, b));
            v = T(edge<double>(a, c));
            w = T(edge<double>(b, a));
        }
        const T sum = u + v + w;
        if (!((u >= 0 && v >= 0 && w >= 0) || (u <= 0 && v <= 0 && w <= 0)) || sum == 0) return std::nullopt;
        const T t = (u * a.z + v * b.z + w * c.z) / sum;
        if (!range.contains(t)) return std::nullopt;
        return Hit<T>{t, {v / sum, w / sum}};
    }

private:
    [[nodiscard]] Vector3<T> seen(const Vector3<T>& vertex) const {
        const Vector3<T> p          = vertex - origin_;
        const T*         coordinate = glm::value_ptr(p);  // GLM's own operator[] branches on the index
        const T          z          = coordinate[z_];
        return {coordinate[x_] - shear_.x * z, coordinate[y_] - shear_.y * z, shear_.z * z};
    }

    template <class Wide>
    [[nodiscard]] static Wide edge(const Vector3<T>& p, const Vector3<T>& q) {
        return Wide(p.x) * Wide(q.y) - Wide(p.y) * Wide(q.x);
    }

    Vector3<T> origin_, shear_;
    int        x_, y_, z_;
};

}  // namespace sr
