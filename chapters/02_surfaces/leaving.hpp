#pragma once
/// @file leaving.hpp
/// Three ways for a ray to leave the surface that it starts on, and what goes wrong with each.

#include <concepts>
#include <limits>

#include "each_ray.hpp"
#include "geometry/offset.hpp"
#include "geometry/ray.hpp"
#include "geometry/sphere.hpp"
#include "math/interval.hpp"
#include "math/vector.hpp"
#include "sampling/ball.hpp"
#include "sampling/rng.hpp"
#include "statistics/estimate.hpp"

namespace sr {

/// A ray, and the t that count as hits.
struct Launch {
    Ray<float>      ray;
    Interval<float> range;
};

/// (2.17) one number for all scenes
[[nodiscard]] inline Launch by_fixed_epsilon(const SurfacePoint<float>& p, const Vec3& direction) {
    return {{p.position, direction}, {1e-4F, in_front<float>.max}};
}

/// Every hit in front counts: what an epsilon does best that is as small as can be
[[nodiscard]] inline Launch by_no_epsilon(const SurfacePoint<float>& p, const Vec3& direction) {
    return {{p.position, direction}, in_front<float>};
}

/// (2.17) in proportion to the coordinates
[[nodiscard]] inline Launch by_scaled_epsilon(const SurfacePoint<float>& p, const Vec3& direction) {
    return {{p.position, direction}, {2e-5F * length(p.position), in_front<float>.max}};
}

/// (2.18)
[[nodiscard]] inline Launch by_error_bound(const SurfacePoint<float>& p, const Vec3& direction) {
    return {leave(p, direction), in_front<float>};
}

/// How directions are spread over the half-space of a normal.
enum class Spread { uniform, cosine };

[[nodiscard]] inline Vector3<double> direction_about(const Vector3<double>& normal, Spread spread, Rng& rng) {
    const auto d = normalize(in_unit_ball<double>(rng));
    if (spread == Spread::cosine) return normalize(d + normal);
    return dot(d, normal) < 0 ? -d : d;
}

/// Rays that hit the surface they leave, and rays into the sphere that miss its other side [% of each].
struct LeavingErrors {
    double self_hits    = 0;
    double lost         = 0;
    double self_hits_se = 0;  ///< their standard errors
    double lost_se      = 0;
};

/// Rays leave a sphere of so large a radius around (7, 5, 3) radii, half of them outwards and half inwards.
template <class Method>
[[nodiscard]] LeavingErrors leaving_errors(double scale, Spread spread, int rays, int threads,
                                           const Method& method) {
    struct Outcome {
        bool self_hit = false, lost = false;
    };
    const Sphere<float> sphere{Vec3(scale * Vector3<double>{7, 5, 3}), float(scale)};
    const auto          outcomes  = each_ray(rays, threads, [&](int i) {
        Rng              rng{3, i, 0, 0};
        const Vec3       eye = sphere.centre + 10 * sphere.radius * normalize(in_unit_ball<float>(rng));
        const Vec3       target = sphere.centre + 0.99F * sphere.radius * in_unit_ball<float>(rng);
        const Ray<float> camera{eye, target - eye};
        const auto       t = intersect(sphere, camera);
        if (!t) return Outcome{true, true};  // aimed inside, and can't be
        const auto p       = surface_point(sphere, camera, *t);
        const auto out     = direction_about(Vector3<double>(p.normal), spread, rng);
        const auto outward = method(p, Vec3(out)), inward = method(p, Vec3(-out));
        return Outcome{intersect(sphere, outward.ray, outward.range).has_value(),
                       !intersect(sphere, inward.ray, inward.range)};
    });
    int                 self_hits = 0, lost = 0;
    for (const auto& outcome : outcomes) {
        self_hits += outcome.self_hit ? 1 : 0;
        lost += outcome.lost ? 1 : 0;
    }
    const Estimate self = percent(share(self_hits, outcomes.size())),
                   gone = percent(share(lost, outcomes.size()));
    return {self.value, gone.value, self.error, gone.error};
}

}  // namespace sr
