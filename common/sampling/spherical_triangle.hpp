#pragma once
/// @file spherical_triangle.hpp
/// Directions to a triangle, each as likely, in the triple sample, pdf, invert.

#include <algorithm>
#include <cmath>
#include <concepts>

#include "math/square.hpp"
#include "math/vector.hpp"
#include "sampling/pdf.hpp"

namespace sr {

/// A triangle as it is seen from the origin: its image on the unit sphere, from which directions are drawn, each as
/// likely. What is drawn is the point of the triangle in such a direction, by its weights as in triangle_points.hpp:
/// of a small triangle a unit vector knows only a few digits, its point has them all. So a small triangle needs no
/// other method, and the smaller it is seen, the more do the points become those of `sample_triangle`.
///
///     const SphericalTriangle<float> seen(a - p, b - p, c - p);
///     const auto x = seen.sample(u);  // lit from (1 - x.x - x.y) a + x.x b + x.y c, with seen.pdf(x)
///
/// Arvo's method. His angles' sum less pi, and the cosines that he goes on with, cancel; tangents of half an angle
/// don't. With A the angle at a, and p and q the tangents of half the sides that meet there, the triangle's solid angle
/// w has
///     tan(w / 2) = p q sin A / (1 + p q cos A),   so   q = sin(w / 2) / (p sin(A - w / 2)).
/// @see Arvo, Stratified Sampling of Spherical Triangles (1995); Todhunter, Spherical Trigonometry, article 103
template <std::floating_point T>
class SphericalTriangle {
public:
    /// @pre the origin does not lie in the triangle's plane, and no product of four lengths under- or overflows: in
    ///      float, at a distance of 1 the sides are longer than 10^-18
    SphericalTriangle(const Vector3<T>& a, const Vector3<T>& b, const Vector3<T>& c)
        : a_{a}, b_{b}, ab_{b - a}, ac_{c - a} {
        const Vector3<T> beside_b = cross(a, ab_), beside_c = cross(a, ac_);
        angle_       = std::atan2(length(a) * std::abs(dot(a, cross(ab_, ac_))), dot(beside_b, beside_c));
        half_ab_     = half_tangent(a, ab_);
        solid_angle_ = cut_off(half_tangent(a, ac_));
    }

    /// [sr]
    [[nodiscard]] T solid_angle() const { return solid_angle_; }

    /// 1 / solid angle, and 0 of weights outside of the triangle.
    [[nodiscard]] Pdf<measure::SolidAngle> pdf(const Vector2<T>& weights) const {
        const bool inside = weights.x >= 0 && weights.y >= 0 && weights.x + weights.y <= 1;
        return {inside ? 1 / double(solid_angle_) : 0};
    }

    /// An arc from b cuts off, on the side of a, the share u.y of the solid angle. On the arc, 1 - cos of the angle
    /// from b is uniform, and so is the square of half that angle's sine: it is the share u.x of the whole arc's.
    /// @pre 0 <= u.x < 1 and 0 <= u.y < 1; solid_angle() > 0, as it is not from within the triangle's plane
    [[nodiscard]] Vector2<T> sample(Vector2<T> u) const {
        // the arc ends on the side a c
        const T          half = u.y * solid_angle_ / 2;
        const T          end  = share(a_, ac_, std::sin(half) / (half_ab_ * std::sin(angle_ - half)));
        const Vector3<T> arc  = end * ac_ - ab_;

        // of the square of the sine, u.x q^2 / (1 + q^2), the tangent without a difference
        const T whole = half_tangent(b_, arc);
        const T part  = whole * std::sqrt(u.x / (1 + (1 - u.x) * square(whole)));
        const T b     = 1 - share(b_, arc, part);
        return {b, end * (1 - b)};
    }

    /// Undoes `sample`. At the corner b itself every u.y is mapped to one point: 0 stands for it.
    /// @pre pdf(weights) > 0
    [[nodiscard]] Vector2<T> invert(const Vector2<T>& weights) const {
        const T s = 1 - weights.x;
        if (!(s > 0)) return {0, 0};
        const T          end = weights.y / s;
        const Vector3<T> arc = end * ac_ - ab_;
        return {squared_sine(half_tangent(b_, s * arc)) / squared_sine(half_tangent(b_, arc)),
                cut_off(half_tangent(a_, end * ac_)) / solid_angle_};
    }

private:
    /// The tangent of half the angle between p and p + way: sin / (1 + cos) or, where that cancels, (1 - cos) / sin.
    [[nodiscard]] static T half_tangent(const Vector3<T>& p, const Vector3<T>& way) {
        const Vector3<T> q = p + way;
        // each times both lengths
        const T          one = length(p) * length(q), sine = length(cross(p, way)), cosine = dot(p, q);
        return cosine > 0 ? sine / (one + cosine) : (one - cosine) / sine;
    }

    /// Where on the way from p it is seen at an angle from p, given by half its tangent: at which share, 0 to 1.
    [[nodiscard]] static T share(const Vector3<T>& p, const Vector3<T>& way, T half) {
        const T aside = length(cross(p, way)) * (1 - half) * (1 + half) - 2 * half * dot(p, way);
        return std::clamp(2 * half * dot(p, p) / aside, T{0}, T{1});
    }

    /// sin^2 of half an angle.
    [[nodiscard]] static T squared_sine(T half_tangent) {
        return square(half_tangent) / (1 + square(half_tangent));
    }

    /// The solid angle between the side a b and one from a that is so long.
    [[nodiscard]] T cut_off(T half_tangent) const {
        const T product = half_ab_ * half_tangent;
        return 2 * std::atan2(product * std::sin(angle_), 1 + product * std::cos(angle_));
    }

    Vector3<T> a_, b_, ab_, ac_;
    T          angle_, half_ab_, solid_angle_;
};

}  // namespace sr
