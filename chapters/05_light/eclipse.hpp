#pragma once
/// @file eclipse.hpp
/// A spherical lamp behind a smaller sphere: how much of it is seen, by rays and in closed form.

#include <cmath>

#include "geometry/sphere.hpp"
#include "math/degrees.hpp"
#include "radiometry/cap_overlap.hpp"
#include "radiometry/solid_angle.hpp"
#include "sampled.hpp"
#include "sampling/cone.hpp"

namespace sr {

/// Seen from the origin: the lamp towards +z, the occluder nearer, `apart` from it.
struct Eclipse {
    double lamp     = radians(30);  ///< half-angle [rad]
    double occluder = radians(20);

    /// What is left of the lamp's solid angle [sr].
    [[nodiscard]] double visible(double apart) const {
        return (cap_solid_angle(lamp) - cap_overlap(lamp, occluder, apart)).value();
    }

    /// The same by (5.11): directions towards the lamp, each asked whether the occluder is in the way.
    [[nodiscard]] Running visible_by_rays(double apart, const Effort& effort) const {
        const Sphere<double> nearer{{2 * std::sin(apart), 0, 2 * std::cos(apart)}, 2 * std::sin(occluder)};
        const double         sine = std::sin(lamp);
        return sampled(effort, [&](Rng& rng) {
            const auto   w = sample_cone(random_point(rng), sine);
            const double V = intersect(nearer, Ray<double>{{0, 0, 0}, w}) ? 0 : 1;
            return V / pdf_cone(w, sine).value;
        });
    }
};

}  // namespace sr
