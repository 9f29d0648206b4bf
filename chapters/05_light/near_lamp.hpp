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

/// One estimate of its irradiance, cos L / pdf. By area the density is that of (5.22), which is as large as r^2 is small.
/// @param h  height of the disk over the receiver
[[nodiscard]] inline double near_lamp_estimate(double h, NearLamp way, Vector2<double> u) {
    const double sine = 1 / std::hypot(1, h);  // of the lamp's half-angle
    if (way == NearLamp::projected_solid_angle)
        return std::numbers::pi * square(sine);  // cos / (cos / pi sin^2)
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
