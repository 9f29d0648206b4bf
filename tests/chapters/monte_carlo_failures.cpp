/// @file monte_carlo_failures.cpp
/// Section 9.10: means that have no variance, and clamped ones that have one and are wrong; oracles H18 and H19, within
/// five standard errors (significance 6e-7 each), seeds fixed.

#include <doctest/doctest.h>

#include <cmath>
#include <tuple>

#include "../../chapters/09_monte_carlo/heavy_tails.hpp"
#include "../../chapters/09_monte_carlo/moments.hpp"
#include "near.hpp"

using namespace sr;
using test::near;

namespace {

bool agrees(Estimate estimate, double exact) {
    return std::abs(estimate.value - exact) <= 5 * estimate.error;
}

}  // namespace

TEST_CASE("H18: 1/sqrt(x), clamped") {
    for (const auto& [clamp, mean, variance] : {std::tuple{10.0, 1.9, 1.9951701859880914},
                                                {100.0, 1.99, 6.2502403719761827},
                                                {1000.0, 1.999, 10.819509557964274}}) {
        CAPTURE(clamp);
        CHECK(clamped_root(clamp).mean == near(mean, 1e-14));
        CHECK(clamped_root(clamp).variance == near(variance, 1e-12));
        const auto seen = moments_of(1, [most = clamp](Rng& rng) { return draw_root(most, rng); });
        CHECK(agrees(seen.mean, mean));
        CHECK(agrees(seen.variance, variance));
        CHECK_FALSE(agrees(seen.mean, 1.03 * mean));
    }
    // At 10, clamping loses more than chance explains.
    CHECK_FALSE(agrees(moments_of(1, [](Rng& rng) { return draw_root(10, rng); }).mean, 2));
}

TEST_CASE("H19: 1/r^2 in a ball, clamped") {
    for (const auto& [clamp, mean, variance] : {std::tuple{10.0, 2.3675444679663241, 4.0438438328755725},
                                                {100.0, 2.8, 29.16},
                                                {1000.0, 2.9367544467966324, 114.86657972595538}}) {
        CAPTURE(clamp);
        CHECK(clamped_in_ball(clamp).mean == near(mean, 1e-14));
        CHECK(clamped_in_ball(clamp).variance == near(variance, 1e-12));
        const auto seen = moments_of(1, [most = clamp](Rng& rng) { return draw_in_ball(most, rng); });
        CHECK(agrees(seen.mean, mean));
        CHECK(agrees(seen.variance, variance));
        CHECK_FALSE(agrees(seen.mean, 1.1 * mean));
    }
    CHECK_FALSE(agrees(moments_of(1, [](Rng& rng) { return draw_in_ball(100, rng); }).mean, 3));
}

TEST_CASE("without a clamp the variance that is seen grows with the samples") {
    const auto seen = [](int n) {
        Running of;
        Rng     rng{2, 0, 0, 0};
        for (int i = 0; i < n; ++i) of.add(draw_in_ball(unclamped, rng));
        return of.variance();
    };
    CHECK(seen(1 << 20) > 3 * seen(1 << 10));
}
