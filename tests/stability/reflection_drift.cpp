/// @file reflection_drift.cpp
/// What becomes of a direction's length after many reflections: row S47. What is asked is asked by chapter 7 as well.

#include <doctest/doctest.h>

#include <cmath>
#include <cstdint>

#include "../../chapters/07_recursion/drift.hpp"
#include "catalogue.hpp"
#include "math/extremes.hpp"

using namespace sr;
using test::within_factor_3;

TEST_CASE("S47: a direction's length drifts over 100 000 reflections; renormalised at each, it does not") {
    // The row is one random walk; here it is the widest of twelve.
    double walk = 0, least_in_sphere = HUGE_VAL, core = 0;
    for (std::uint64_t seed = 0; seed < 12; ++seed) {
        walk            = max_or_nan(walk, std::abs(drift_among_mirrors(seed, {100'000})[0]));
        least_in_sphere = min_or_nan(least_in_sphere, drift_in_sphere(seed, {100'000}, turn_at_school)[0]);
        core            = max_or_nan(core, std::abs(drift_in_sphere(seed, {100'000}, turn_renormalised)[0]));
    }
    CAPTURE(walk);
    CAPTURE(least_in_sphere);
    CAPTURE(core);
    CHECK(within_factor_3(walk, 9.88e-5));
    CHECK(within_factor_3(least_in_sphere, 0.013));  // where errors are alike, they add up
    CHECK(core <= 2e-7);
}

TEST_CASE("S47: a ray of any length leaves a mirror as a unit vector") {
    const Ray<float>          ray{{0, 0, 0}, {3, 0, -4}};
    const SurfacePoint<float> floor{{0, 0, 0}, {0, 0, 1}, 0};
    CHECK(length(reflected(ray, floor).direction - Vec3{0.6F, 0, 0.8F}) <= 1e-7F);
    CHECK(length(refracted(ray, floor, 1.0F)->direction - Vec3{0.6F, 0, -0.8F}) <= 1e-7F);
}
