#pragma once
/// @file spherical_rectangle.hpp
/// Directions to a rectangle, each as likely, in the triple sample, pdf, invert.

#include <algorithm>
#include <cmath>
#include <concepts>
#include <numbers>

#include "math/vector.hpp"
#include "sampling/pdf.hpp"

namespace sr {

/// A rectangle as it is seen from the origin: its image on the unit sphere, from which directions are drawn, each as
/// likely. Where the light is near, its points are not: area sampling's worst case (row S54) is gone.
/// @see Urena, Fajardo and King, An Area-Preserving Parametrization for Spherical Rectangles (2013)
template <std::floating_point T>
class SphericalRectangle {
public:
    /// The points (x, y, z) with x and y between the corners'.
    /// @pre low.x < high.x and low.y < high.y; z > 0; the solid angle is not so small that it is lost in 2 pi
    SphericalRectangle(Vector2<T> low, Vector2<T> high, T z) : low_{low}, high_{high}, z_{z} {
        // normals of the planes through the origin and an edge of y; those of x likewise
        b0_              = -low.y / std::hypot(low.y, z);
        b1_              = high.y / std::hypot(high.y, z);
        const T    a0    = -low.x / std::hypot(low.x, z);
        const T    a1    = high.x / std::hypot(high.x, z);
        const auto angle = [](T p, T q) { return std::acos(-p * q); };  // inner, at a corner
        k_               = 2 * std::numbers::pi_v<T> - angle(b1_, a0) - angle(a0, b0_);
        solid_angle_     = angle(b0_, a1) + angle(a1, b1_) - k_;
    }

    [[nodiscard]] T solid_angle() const { return solid_angle_; }

    /// 1 / solid angle, and 0 of a direction that passes by the rectangle.
    /// @param w  of any length: a point that was drawn is one
    [[nodiscard]] Pdf<measure::SolidAngle> pdf(const Vector3<T>& w) const {
        const auto p      = point(w);
        const bool inside = w.z > 0 && p.x >= low_.x && p.x <= high_.x && p.y >= low_.y && p.y <= high_.y;
        return {inside ? 1 / double(solid_angle_) : 0};
    }

    /// The point of the rectangle in a direction drawn: u.x is the share of the solid angle that lies at smaller x, and
    /// at that x, u.y that at smaller y.
    /// @pre 0 <= u.x < 1 and 0 <= u.y < 1
    [[nodiscard]] Vector3<T> sample(Vector2<T> u) const {
        const T angle = u.x * solid_angle_ + k_;
        const T f     = (std::cos(angle) * b0_ - b1_) / std::sin(angle);
        const T c     = std::clamp(std::copysign(1 / std::hypot(f, b0_), f), T{-1}, T{1});
        const T x     = std::clamp(c * z_ / std::sqrt((1 - c) * (1 + c)), low_.x, high_.x);
        const T d     = std::hypot(x, z_);
        const T h0 = sine(low_.y, d), h1 = sine(high_.y, d);
        const T h = h0 + u.y * (h1 - h0);
        return {x, std::clamp(h * d / std::sqrt((1 - h) * (1 + h)), low_.y, high_.y), z_};
    }

    /// The two shares of a direction: undoes `sample`.
    /// @pre pdf(w) > 0
    [[nodiscard]] Vector2<T> invert(const Vector3<T>& w) const {
        const auto p       = point(w);
        const T    smaller = SphericalRectangle(low_, {p.x, high_.y}, z_).solid_angle();
        const T    d       = std::hypot(p.x, z_);
        const T    h0 = sine(low_.y, d), h1 = sine(high_.y, d);
        return {smaller / solid_angle_, (sine(p.y, d) - h0) / (h1 - h0)};
    }

private:
    /// Where a direction meets the rectangle's plane.
    [[nodiscard]] Vector2<T> point(const Vector3<T>& w) const { return z_ / w.z * Vector2<T>(w); }

    /// Of the elevation at which y is seen, at the distance d from the x axis's plane.
    [[nodiscard]] static T sine(T y, T d) { return y / std::hypot(y, d); }

    Vector2<T> low_, high_;
    T          z_;
    T          b0_, b1_, k_, solid_angle_;
};

}  // namespace sr
