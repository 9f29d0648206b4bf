#pragma once
/// @file tilted_facet.hpp
/// Lambert's cosine law as an experiment: light of a distant round lamp falls on a facet that is turned, and what
/// arrives is counted.

#include <cmath>
#include <numbers>

#include "geometry/plane.hpp"
#include "geometry/ray.hpp"
#include "math/square.hpp"
#include "sampled.hpp"
#include "sampling/disk.hpp"

namespace sr {

/// Light that comes along -z within a cone, the same radiance from each of its directions.
struct Sunlight {
    double sine = 0.05;  ///< of the cone's half-angle: 3 degrees, ten times the sun's

    /// A ray of it through the square |x|, |y| <= 1 in the plane z = 0, each as likely by flux: points are uniform in
    /// the square, and directions in the cone's shadow on it, which puts the cosine in.
    [[nodiscard]] Ray<double> ray(Rng& rng) const {
        const auto   p = random_point(rng);
        const auto   d = sample_disk(random_point(rng), sine);
        const double z = -std::sqrt(1 - dot(d, d));
        return {{2 * p.x - 1 - d.x / z, 2 * p.y - 1 - d.y / z, 1}, {d.x, d.y, z}};
    }
};

/// The share of the light through the square that a disk about the origin with radius 0.6, tilted by the angle
/// [rad], catches; times the ratio of the areas, which makes it the irradiance relative to that of the square.
[[nodiscard]] inline Running relative_irradiance(double tilt, const Effort& effort) {
    constexpr double    radius = 0.6;
    const Plane<double> plane{{0, 0, 0}, {std::sin(tilt), 0, std::cos(tilt)}};
    const double        ratio = 4 / (std::numbers::pi * square(radius));
    const Sunlight      sun;
    return sampled(effort, [&](Rng& rng) {
        const auto ray = sun.ray(rng);
        const auto t   = intersect(plane, ray, {-HUGE_VAL, HUGE_VAL});
        return t && length(ray.at(*t)) <= radius ? ratio : 0;
    });
}

}  // namespace sr
