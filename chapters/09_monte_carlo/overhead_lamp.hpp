#pragma once
/// @file overhead_lamp.hpp

#include <cmath>
#include <numbers>

#include "math/square.hpp"
#include "moments.hpp"
#include "sampling/cone.hpp"
#include "sampling/disk.hpp"
#include "sampling/hemisphere.hpp"
#include "two_densities.hpp"

namespace sr {

/// The irradiance of a unit disk of radiance 1, parallel to the receiver right below its centre: pi / (1 + h^2). Each
/// way is one estimate of it, divided by it.
/// @param height  of the disk over the receiver [radii]
class OverheadLamp {
public:
    explicit OverheadLamp(double height) : h_{height}, sine_{1 / std::hypot(1, height)} {}

    [[nodiscard]] double by_area(Vector2<double> u) const {
        const auto w = towards_point(u);
        return relative(w.z / pdf_area(w));
    }

    [[nodiscard]] double by_solid_angle(Vector2<double> u) const {
        const auto w = sample_cone(u, sine_);
        return relative(w.z / pdf_cone(w, sine_).value);
    }

    /// By the cosine, as a diffuse surface draws directions that knows nothing of lamps.
    [[nodiscard]] double by_cosine(Vector2<double> u) const {
        const auto w = sample_cosine_hemisphere(u);
        return relative(hits(w) ? w.z / pdf_cosine_hemisphere(w).value : 0);
    }

    /// One sample by area and one by the cosine.
    [[nodiscard]] double by_both(Heuristic heuristic, Vector2<double> u, Vector2<double> v) const {
        const auto   a = towards_point(u), c = sample_cosine_hemisphere(v);
        const double a_by_area = pdf_area(a), a_by_cosine = pdf_cosine_hemisphere(a).value;
        double       sum = weight_of(heuristic, a_by_area, a_by_cosine) * a.z / a_by_area;
        if (hits(c)) {
            const double by_cosine = pdf_cosine_hemisphere(c).value;
            sum += weight_of(heuristic, by_cosine, pdf_area(c)) * c.z / by_cosine;
        }
        return relative(sum);
    }

    /// The standard deviations of the first three, in closed form. That by area is (9.18).
    [[nodiscard]] double deviation_by_area() const {
        const double h2 = square(h_);
        return std::sqrt(square(1 + h2) * square(h2) * (std::pow(h2, -3) - std::pow(1 + h2, -3)) / 3 - 1);
    }
    [[nodiscard]] double deviation_by_solid_angle() const {
        return cone_height(sine_) / (2 - cone_height(sine_)) / std::sqrt(3);
    }
    [[nodiscard]] double deviation_by_cosine() const { return h_; }

private:
    [[nodiscard]] Vector3<double> towards_point(Vector2<double> u) const {
        return normalize(Vector3<double>{sample_disk(u, 1.0), h_});
    }
    [[nodiscard]] bool hits(const Vector3<double>& w) const {
        return square(w.x) + square(w.y) <= square(sine_);
    }
    /// Of a direction to the disk [1/sr].
    [[nodiscard]] double pdf_area(const Vector3<double>& w) const {
        return to_solid_angle({1 / std::numbers::pi}, square(h_ / w.z), w.z).value;
    }
    [[nodiscard]] double relative(double estimate) const {
        return estimate * (1 + square(h_)) / std::numbers::pi;
    }

    double h_, sine_;
};

}  // namespace sr
