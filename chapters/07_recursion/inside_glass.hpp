#pragma once
/// @file inside_glass.hpp
/// Section 7.8: light that is reflected again and again inside a glass ball, small or large.

#include <cmath>
#include <optional>
#include <vector>

#include "geometry/offset.hpp"
#include "geometry/sphere.hpp"
#include "sampling/ball.hpp"
#include "sampling/rng.hpp"
#include "transport/tiles.hpp"

namespace sr {

/// Where a ray starts that leaves a surface, and from which t on it takes hits.
struct Departure {
    Ray<float>      ray;
    Interval<float> range = in_front<float>;
};

[[nodiscard]] inline Departure leave_by_fixed_epsilon(const SurfacePoint<float>& p, const Vec3& d) {
    return {{p.position, d}, {1e-4F, in_front<float>.max}};
}
[[nodiscard]] inline Departure leave_by_error_bound(const SurfacePoint<float>& p, const Vec3& d) {
    return {leave(p, d)};
}

/// By how much light's chord of a ball grows in so many bounces from one side to the other, relative to the first:
/// exactly, by 0. None if it goes astray: the ball is not found again, or is found where the ray starts, before half of
/// the chord.
template <class Depart>
[[nodiscard]] std::optional<float> growth_inside(float radius, int bounces, Rng& rng, const Depart& depart) {
    const Sphere<float> ball{radius * Vec3{7, 5, 3}, radius};
    const Vec3          n     = normalize(in_unit_ball<float>(rng));
    const Vec3          any   = normalize(in_unit_ball<float>(rng));
    SurfacePoint<float> here  = surface_point(ball, {ball.centre, n}, radius);
    Vec3                d     = dot(any, n) < 0 ? any : -any;
    const float         first = -dot(d, here.normal);  // a chord is 2 r cos
    for (int i = 0; i < bounces; ++i) {
        const Departure next = depart(here, d);
        const auto      t    = intersect(ball, next.ray, next.range);
        if (!t || !(*t >= -radius * dot(d, here.normal))) return std::nullopt;
        here = surface_point(ball, next.ray, *t);
        d    = normalize(d - 2 * dot(d, here.normal) * here.normal);
    }
    return -dot(d, here.normal) / first - 1;
}

/// Of so many rays: those that go astray within 20 bounces, and those whose chord changes by more than 1 %.
struct InsideCount {
    int astray  = 0;
    int drifted = 0;
};

template <class Depart>
[[nodiscard]] InsideCount count_inside(float radius, int rays, int threads, const Depart& depart) {
    std::vector<std::optional<float>> growth(std::size_t(rays), 0.0F);
    for_each_pixel(rays, 1, {.threads = threads}, [&](int i, int) {
        Rng rng{8, i, 0, 0};
        growth[std::size_t(i)] = growth_inside(radius, 20, rng, depart);
    });
    InsideCount count;
    for (const auto& one : growth) {
        count.astray += one ? 0 : 1;
        count.drifted += one && !(std::abs(*one) <= 0.01F) ? 1 : 0;
    }
    return count;
}

}  // namespace sr
