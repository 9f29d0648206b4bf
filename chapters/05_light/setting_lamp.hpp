#pragma once
/// @file setting_lamp.hpp
/// A spherical lamp that sets: its irradiance, in closed form and by rays.

#include <cmath>

#include "geometry/sphere.hpp"
#include "math/frame.hpp"
#include "radiometry/projected_solid_angle.hpp"
#include "sampled.hpp"
#include "sampling/cone.hpp"

namespace sr {

/// Radiance 1, seen under half an angle with the sine 1/2, its centre at the angle beta [rad] from the normal.
struct SettingLamp {
    double sine = 0.5;

    [[nodiscard]] double irradiance(double beta) const {
        return projected_solid_angle(Sphere<double>{{std::sin(beta), 0, std::cos(beta)}, sine}).value();
    }

    /// As a point light of the same flux: (5.16) without a horizon for its disk.
    [[nodiscard]] double as_a_point(double beta) const {
        const double cosine = std::cos(beta);
        return cosine < 0 ? 0 : std::numbers::pi * square(sine) * cosine;
    }

    [[nodiscard]] Running by_rays(double beta, const Effort& effort) const {
        const auto frame = frame_around(Vector3<double>{std::sin(beta), 0, std::cos(beta)});
        return sampled(effort, [&](Rng& rng) {
            const auto   w      = sample_cone(random_point(rng), sine);
            const double cosine = frame.to_world(w).z;
            return cosine > 0 ? cosine / pdf_cone(w, sine).value : 0;
        });
    }
};

}  // namespace sr
