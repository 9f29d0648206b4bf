/// @file fireflies.cpp
/// A small lamp that directions hardly ever find: row S49.

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <tuple>

#include "../../chapters/09_monte_carlo/small_lamp.hpp"
#include "near.hpp"

using namespace sr;
using test::near;

TEST_CASE(
    "S49: by the cosine a small lamp is black in most pixels, its median lies, and clamping loses it; by its "
    "cone it is found") {
    const double   sine = 0.05 / 2;
    const RareHits hits{sine * sine};
    CHECK(hits.q == near(6.25e-4, 1e-12));
    struct Row {
        int    n, pixels;
        double deviation, black, median;  // as the catalogue has them, the first by theory
    };
    for (const auto& [n, pixels, deviation, black, median_seen] :
         {Row{64, 16'384, 5.00, 0.96, 0}, {1024, 4096, 1.25, 0.53, 0}, {16'384, 256, 0.31, 0, 0.98}}) {
        CAPTURE(n);
        const auto seen = look_for_lamp(sine, n, pixels, 2);
        Running    of;
        for (const double x : seen) of.add(x);
        const Estimate dark = share(int(std::ranges::count(seen, 0.0)), seen.size());
        CHECK(std::abs(of.mean() - 1) <= 5 * of.standard_error());
        CHECK(std::abs(dark.value - hits.black(n)) <= 5 * dark.error);
        CHECK(std::abs(hits.black(n) - black) <= 0.005);
        CHECK(std::abs(hits.deviation(n) - deviation) <= 0.005);
        // The binomial's kurtosis less 3 is about 1 / nq, so that s^2 varies by sqrt((1 / nq + 2) / pixels) of itself
        // and s by half of that: 3 of its standard errors (significance 3e-3; 0.06, 0.04 and 0.14).
        const double of_s = std::sqrt((1 / (n * hits.q) + 2) / pixels) / 2;
        CHECK(std::sqrt(of.variance()) == near(hits.deviation(n), 3 * of_s));
        CHECK(std::abs(hits.median(n) - median_seen) <= 0.005);
        CHECK(std::abs(median(seen).value - hits.median(n)) <= 5 * median(seen).error + 1e-12);
    }
    CHECK(10 * hits.q == near(0.00625, 1e-12));  // what is left when 1 / q is clamped to 10

    // In the room: the same mean below the lamp, with the deviation of a cone of half a degree.
    const SmallLampRoom room;
    const auto          below = [&](LampSampling way) {
        return moments_of(7, [&](Rng& rng) {
            return room.sample({-0.6, -0.5, 0}, {0, 0, 1}, way, draw_pair(rng)) / SmallLampRoom::overhead;
        });
    };
    const auto by_cosine = below(LampSampling::cosine), clamped = below(LampSampling::clamped),
               by_cone = below(LampSampling::cone);
    CHECK(std::abs(by_cosine.mean.value - 1) <= 5 * by_cosine.mean.error);
    CHECK(std::abs(by_cone.mean.value - 1) <= 5 * by_cone.mean.error);
    CHECK(std::abs(clamped.mean.value - 0.00625) <= 5 * clamped.mean.error);
    // As seldom as the lamp is hit, the variance is known as well as the number of hits, 2^18 q: to 8 %; five of that.
    CHECK(by_cosine.variance.value == near(1 / hits.q - 1, 5 / std::sqrt(0x1p18 * hits.q)));
    CHECK(std::sqrt(by_cone.variance.value) <= 1e-4);
}
