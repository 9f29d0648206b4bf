#pragma once
/// @file drift.hpp
/// Section 7.8: what becomes of a direction's length, bounce after bounce, if nobody looks after it.

#include <cmath>
#include <cstdint>
#include <vector>

#include "geometry/offset.hpp"
#include "geometry/sphere.hpp"
#include "sampling/ball.hpp"
#include "sampling/rng.hpp"
#include "transport/interaction.hpp"

namespace sr {

/// The school's reflection, d - 2 (d.n) n: as long as d was, if n is a unit vector.
[[nodiscard]] inline Vec3 school_reflection(const Vec3& d, const Vec3& n) {
    return d - 2 * dot(d, n) * n;
}

/// |d| - 1 after each number of bounces that is asked for, in increasing order.
/// @param bounce  Ray<float> -> Ray<float>
template <class Bounce>
[[nodiscard]] std::vector<double> drift(Ray<float> ray, const std::vector<int>& after, const Bounce& bounce) {
    std::vector<double> lengths;
    int                 done = 0;
    for (const int bounces : after) {
        for (; done < bounces; ++done) ray = bounce(ray);
        lengths.push_back(length(Vector3<double>(ray.direction)) - 1);
    }
    return lengths;
}

/// Mirrors at random: what is rounded away once is added another time.
[[nodiscard]] inline std::vector<double> drift_among_mirrors(std::uint64_t           seed,
                                                             const std::vector<int>& after) {
    Rng        rng{seed, 0, 0, 0};
    const Vec3 d = normalize(in_unit_ball<float>(rng));
    return drift({{0, 0, 0}, d}, after, [&](const Ray<float>& ray) {
        return Ray<float>{ray.origin, school_reflection(ray.direction, normalize(in_unit_ball<float>(rng)))};
    });
}

/// The inside of a sphere: each bounce has the angles, and with them the errors, of the one before.
/// @param turn  (Ray<float>, SurfacePoint<float>) -> Ray<float>
template <class Turn>
[[nodiscard]] std::vector<double> drift_in_sphere(std::uint64_t seed, const std::vector<int>& after,
                                                  const Turn& turn) {
    Rng                 rng{seed, 0, 0, 0};
    const Sphere<float> sphere{{0, 0, 0}, 1};
    const Vec3          origin = 0.5F * in_unit_ball<float>(rng);
    return drift({origin, normalize(in_unit_ball<float>(rng))}, after, [&](const Ray<float>& ray) {
        const auto t = intersect(sphere, ray);
        return t ? turn(ray, surface_point(sphere, ray, *t)) : Ray<float>{};
    });
}

[[nodiscard]] inline Ray<float> turn_at_school(const Ray<float>& ray, const SurfacePoint<float>& point) {
    return leave(point, school_reflection(ray.direction, point.normal));
}

[[nodiscard]] inline Ray<float> turn_renormalised(const Ray<float>& ray, const SurfacePoint<float>& point) {
    return reflected(ray, point);
}

}  // namespace sr
