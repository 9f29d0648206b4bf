/// @file grazing_departures.cpp
/// On which side of a surface does a ray start that grazes it?

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

#include "sampling/ball.hpp"
#include "sampling/rng.hpp"
#include "transport/interaction.hpp"

using namespace sr;

TEST_CASE("a grazing ray leaves to the side that wi says; the direction in space says another one") {
    Rng rng{51, 0, 0, 0};
    int turned_in_space = 0, turned = 0;
    for (int i = 0; i < 100'000; ++i) {
        const SurfacePoint<float> point{{0, 0, 0}, normalize(in_unit_ball<float>(rng)), 1e-6F};
        const Interaction<float>  at(point, -point.normal, Sides::two);
        const float               phi = 2 * std::numbers::pi_v<float> * rng.uniform();
        const Vec3                wi{std::cos(phi), std::sin(phi), 1e-7F * (2 * rng.uniform() - 1)};
        const Ray<float>          ray     = at.leave(wi);
        const auto                on_side = [&](const Vec3& origin) {
            return (dot(origin, point.normal) > 0) == (wi.z > 0);
        };
        turned += on_side(ray.origin) ? 0 : 1;
        turned_in_space += on_side(off_surface(point, ray.direction)) ? 0 : 1;
    }
    CHECK(turned == 0);
    CHECK(turned_in_space >= 10'000);
}
