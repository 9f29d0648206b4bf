/// @file monte_carlo_adaptive.cpp
/// Section 9.9: how samples are shared out, the floor with its shadows, and what stopping does to a mean. What has
/// chance in it is within five standard errors (significance 6e-7 each), seeds fixed.

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <limits>
#include <numeric>

#include "../../chapters/09_monte_carlo/adaptive_picture.hpp"
#include "../../chapters/09_monte_carlo/stopping.hpp"
#include "../../chapters/09_monte_carlo/strata.hpp"
#include "near.hpp"

using namespace sr;
using test::near;

TEST_CASE("samples are shared out by weight, above the least, and none is lost") {
    CHECK(allocated(std::array{1.0, 3.0, 0.0}, 43, 1) == std::vector{11, 31, 1});
    for (const int total : {48, 49, 1024, 99'999}) {
        const auto counts = allocated(deviations_in_strata(), total, 3);
        CHECK(std::accumulate(counts.begin(), counts.end(), 0) == total);
        for (const int count : counts) CHECK(count >= 3);
    }
    CHECK_THROWS_AS((void)allocated(std::array{1.0, 1.0}, 1, 1), std::invalid_argument);
    CHECK_THROWS_AS((void)allocated(std::array{0.0, 0.0}, 9, 1), std::invalid_argument);
    CHECK_THROWS_AS((void)allocated(std::array{1.0, std::numeric_limits<double>::quiet_NaN()}, 9, 1),
                    std::invalid_argument);
}

TEST_CASE("(9.26): the gain of Neyman's allocation, and no other allocation has more") {
    const auto   deviations = deviations_in_strata();
    const double n          = 1 << 20;  // so many that rounding the counts is nothing
    double       mean = 0, squares = 0;
    for (const double deviation : deviations) {
        mean += deviation / strata;
        squares += square(deviation) / strata;
    }
    const std::vector<int> even(strata, int(n) / strata);
    const auto             best = allocated(deviations, int(n), 1);
    CHECK(variance_in_strata(even) == near(squares / n, 1e-12));
    CHECK(variance_in_strata(best) == near(square(mean) / n, 1e-4));
    auto other = best;
    other[15] -= 50'000;
    other[7] += 50'000;
    CHECK(variance_in_strata(other) > 1.005 * variance_in_strata(best));

    Running    of, wrong;  // as many samples as 9.9 has
    const auto counts = allocated(deviations, 1024, 1);
    for (int i = 0; i < 4096; ++i) {
        Rng          rng{1, i, 0, 0};
        const double value = estimate_in_strata(counts, rng);
        of.add(value);
        wrong.add(1.02 * value);
    }
    CHECK(std::abs(of.mean() - 1.0 / 6) <= 5 * of.standard_error());
    CHECK(std::abs(wrong.mean() - 1.0 / 6) > 5 * wrong.standard_error());
    CHECK(of.variance() == near(variance_in_strata(counts), 5 * std::sqrt(2.0 / 4096)));
}

TEST_CASE("the floor's samples have the mean of its closed form, lit, half-lit and dark") {
    for (const auto& [x, y] :
         {std::pair{32, 32}, {12, 12}, {10, 20}, {56, 20}, {38, 52}, {18, 18}, {18, 10}}) {
        CAPTURE(x);
        CAPTURE(y);
        const auto point = floor_at(x, y, 64);
        Running    of;
        Rng        rng{1, x, y, 0};
        for (int i = 0; i < 20'000; ++i) of.add(point.sample(draw_pair(rng)));
        CHECK(std::abs(of.mean() - point.exact()) <= 5 * of.standard_error() + 1e-12);
        if (point.exact() > 0)
            CHECK_FALSE(std::abs(1.05 * of.mean() - point.exact()) <= 5 * of.standard_error());
        CHECK(point.exact() <= point.most());
    }
    CHECK(std::abs(floor_at(18, 18, 64).exact()) <= 1e-12);
}

TEST_CASE("what stopping does to a mean is what the runs show; a pilot that is forgotten does nothing") {
    const StoppingRule naive{16, 0.01, error_of_samples}, cured{16, 0.01, error_never_zero};
    const double       p       = 0.05;
    const auto         mean_of = [&](const auto& run) {
        Running of;
        for (int i = 0; i < 4096; ++i) {
            Rng rng{2, i, 0, 0};
            of.add(run(rng));
        }
        return of;
    };
    const auto agrees = [](const Running& of, double exact) {
        return std::abs(of.mean() - exact) <= 5 * of.standard_error();
    };
    const auto by_itself = mean_of([&](Rng& rng) { return run_until_stopped(naive, p, rng); });
    CHECK(agrees(by_itself, stopped(naive, p).mean));
    CHECK_FALSE(agrees(by_itself, p));
    CHECK(stopped(naive, p).misses == near(std::pow(0.95, 16), 1e-12));
    const auto never_sure = mean_of([&](Rng& rng) { return run_until_stopped(cured, p, rng); });
    CHECK(agrees(never_sure, stopped(cured, p).mean));
    CHECK_FALSE(agrees(never_sure, p));
    CHECK(agrees(mean_of([&](Rng& rng) { return run_by_pilot(cured, p, rng); }), p));
    CHECK(decided_by_pilot(cured, p).rms <= 0.01);
    // A rule that always stops at 16 chooses nothing: binomial.
    const Stopped fixed = stopped({16, 1, error_of_samples}, p);
    CHECK(fixed.mean == near(p, 1e-12));
    CHECK(fixed.rms == near(std::sqrt(p * (1 - p) / 16), 1e-12));
    CHECK(fixed.samples == near(16, 1e-12));
}
