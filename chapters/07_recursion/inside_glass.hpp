#pragma once
/// @file inside_glass.hpp
/// Section 7.8: light that is reflected again and again inside a glass ball, small or large.

#include <cmath>
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

/// Whether light makes so many bounces inside a ball, from one side to the other: not if the ball is not found
/// again, nor if it is found where the ray starts, before half of its chord.
template <class Depart>
[[nodiscard]] bool stays_inside(float radius, int bounces, Rng& rng, const Depart& depart) {
    const Sphere<float> ball{radius * Vec3{7, 5, 3}, radius};
    const Vec3          n    = normalize(in_unit_ball<float>(rng));
    const Vec3          any  = normalize(in_unit_ball<float>(rng));
    SurfacePoint<float> here = surface_point(ball, {ball.centre, n}, radius);
    Vec3                d    = dot(any, n) < 0 ? any : -any;
    for (int i = 0; i < bounces; ++i) {
        const Departure next = depart(here, d);
        const auto      t    = intersect(ball, next.ray, next.range);
        if (!t || !(*t >= -radius * dot(d, here.normal))) return false;  // the chord is 2 r cos
        here = surface_point(ball, next.ray, *t);
        d    = normalize(d - 2 * dot(d, here.normal) * here.normal);
    }
    return true;
}

/// The number of rays, of so many, that go astray within 20 bounces.
template <class Depart>
[[nodiscard]] int astray(float radius, int rays, int threads, const Depart& depart) {
    std::vector<char> lost(std::size_t(rays), 0);
    for_each_pixel(rays, 1, {.threads = threads}, [&](int i, int) {
        Rng rng{8, i, 0, 0};
        lost[std::size_t(i)] = stays_inside(radius, 20, rng, depart) ? 0 : 1;
    });
    int sum = 0;
    for (const char one : lost) sum += one;
    return sum;
}

}  // namespace sr
