#pragma once
/// @file near_lamp.hpp
/// A unit disk that shines with radiance 1, parallel to a receiver close to its centre: three ways to sample it.

#include <cmath>
#include <numbers>

#include "math/square.hpp"
#include "math/vector.hpp"
#include "sampling/cone.hpp"
#include "sampling/disk.hpp"
#include "sampling/pdf.hpp"
#include "sampling/rng.hpp"
#include "statistics/running.hpp"

namespace sr {

enum class NearLamp { area, solid_angle, projected_solid_angle };

/// A direction of the cone about +z by its foot on the receiver's plane, whose points are drawn alike: uniform in the
/// projected solid angle.
/// @param sine  of the cone's half-angle, at most 1
[[nodiscard]] inline Vector3<double> sample_projected_cone(Vector2<double> u, double sine) {
    const auto foot = sample_disk(u, sine);
    return {foot, std::sqrt(1 - dot(foot, foot))};
}

/// cos / (pi sine^2), for cos d(omega) is the area of the foot; 0 outside of the cone.
[[nodiscard]] inline Pdf<measure::SolidAngle> pdf_projected_cone(const Vector3<double>& w, double sine) {
    return {w.z * pdf_disk(Vector2<double>(w), sine).value};
}

/// One estimate of its irradiance, cos L / pdf. By area the density is that of (5.22), which is as large as r^2 is
/// small.
/// @param h  height of the disk over the receiver
[[nodiscard]] inline double near_lamp_estimate(double h, NearLamp way, Vector2<double> u) {
    const double sine = 1 / std::hypot(1, h);  // of the lamp's half-angle
    if (way == NearLamp::projected_solid_angle) {
        const auto w = sample_projected_cone(u, sine);
        return w.z / pdf_projected_cone(w, sine).value;
    }
    if (way == NearLamp::solid_angle) {
        const auto w = sample_cone(u, sine);
        return w.z / pdf_cone(w, sine).value;
    }
    const auto   p      = sample_disk(u, 1.0);
    const double r2     = dot(p, p) + h * h;
    const double cosine = h / std::sqrt(r2);
    return cosine / to_solid_angle(pdf_disk(p, 1.0), r2, cosine).value;
}

[[nodiscard]] inline Running sample_near_lamp(double h, NearLamp way, int samples) {
    Running of;
    Rng     rng{1, 0, 0, 0};
    for (int i = 0; i < samples; ++i) {
        const double x = rng.uniform<double>();
        of.add(near_lamp_estimate(h, way, {x, rng.uniform<double>()}));
    }
    return of;
}

}  // namespace sr
