/// @file leaving_a_surface.cpp
/// Rays that leave a sphere, by an epsilon and by an error bound: rows S4, S5 and S6. What is asked is asked by
/// chapter 2 as well.

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "../../chapters/02_surfaces/leaving.hpp"
#include "../../chapters/02_surfaces/textbook_sphere.hpp"
#include "catalogue.hpp"
#include "math/extremes.hpp"
#include "sampling/ball.hpp"
#include "sampling/rng.hpp"

using namespace sr;
using test::within_factor_3;

namespace {

constexpr int rays = 50'000;

}  // namespace

TEST_CASE("S4: without an offset rays meet the sphere that they leave outwards; with one, none does") {
    struct Row {
        float  x;  ///< of the centre
        double self_hits, largest_t;
    };
    for (const auto& [x, self_hits, largest_t] : {Row{0, 17.3, 0.00022}, Row{1000, 49.7, 0.0069}}) {
        CAPTURE(x);
        const Sphere<float> sphere{{x, 0, 0}, 1};
        int                 school = 0, offset = 0;
        double              largest = 0;
        for (int i = 0; i < rays; ++i) {
            Rng              rng{5, i, 0, 0};
            const auto       n = normalize(in_unit_ball<double>(rng));
            const Vec3       p(Vector3<double>(sphere.centre) + n);
            const Ray<float> ray{p, Vec3(direction_about(n, Spread::uniform, rng))};
            const auto       roots = textbook_crossings(sphere, ray);
            if (roots && roots->second > 0) {
                ++school;
                largest = max_or_nan(largest, double(roots->first > 0 ? roots->first : roots->second));
            }
            const auto on_sphere = surface_point(sphere, {p, {0, 0, 0}}, 0.0F);
            if (dot(ray.direction, on_sphere.normal) > 1e-6F)
                offset += intersect(sphere, leave(on_sphere, ray.direction)) ? 1 : 0;
        }
        CHECK(within_factor_3(100.0 * school / rays, self_hits));
        CHECK(within_factor_3(largest, largest_t));
        CHECK(offset == 0);
    }
}

TEST_CASE("S5: t >= 0.0001 shadows large spheres by themselves; an error bound none of any size") {
    for (const double scale : {1e-4, 1e-2, 1.0, 1e2, 1e4, 1e6}) {
        CAPTURE(scale);
        const auto fixed = leaving_errors(scale, Spread::cosine, rays, 2, by_fixed_epsilon);
        const auto bound = leaving_errors(scale, Spread::cosine, rays, 2, by_error_bound);
        if (scale <= 1) CHECK(fixed.self_hits == 0);
        if (scale == 1e2) CHECK(within_factor_3(fixed.self_hits, 0.95));
        if (scale >= 1e4) CHECK(within_factor_3(fixed.self_hits, 42));
        CHECK(bound.self_hits == 0);
    }
}

TEST_CASE("S6: t >= 0.0001 loses the other side of small spheres; an error bound of none") {
    // Inside, a cosine-distributed ray's chord l = 2 s cos has P(l < epsilon) = (epsilon / 2 s)^2.
    for (const double scale : {1e-5, 1e-4, 1e-3, 1.0}) {
        CAPTURE(scale);
        const auto   fixed = leaving_errors(scale, Spread::cosine, rays, 2, by_fixed_epsilon);
        const auto   bound = leaving_errors(scale, Spread::cosine, rays, 2, by_error_bound);
        const double law   = std::min(1.0, std::pow(1e-4 / (2 * scale), 2));
        const double sigma = std::sqrt(law * (1 - law) / rays);
        CHECK(std::abs(fixed.lost / 100 - law) <= 5 * sigma + 1e-5);  // at 5 sigma, one chance in a million
        CHECK(bound.lost == 0);
    }
}
