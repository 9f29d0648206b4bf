/// @file light_transport_roulette.cpp
/// Section 10.4: roulette is right on average, and its variance and cost are those of the oracle H16. Statistical tests
/// ask for five standard errors (significance 6e-7 each), seeds fixed.

#include <doctest/doctest.h>

#include <cmath>
#include <cstdint>
#include <tuple>

#include "../../chapters/10_light_transport/cut_paths.hpp"
#include "../../chapters/10_light_transport/roulette_charts.hpp"
#include "../../chapters/10_light_transport/squeezed_paths.hpp"
#include "material/fresnel.hpp"
#include "math/gauss_legendre.hpp"
#include "near.hpp"

using namespace sr;
using test::near;

namespace {

bool agrees(Estimate estimate, double exact) {
    return std::abs(estimate.value - exact) <= 5 * estimate.error;
}

}  // namespace

TEST_CASE("H16: roulette's mean, variance and bounces in a furnace") {
    for (const auto& [rho, q, variance, bounces] :
         {std::tuple{0.5, 0.5, 2.0, 1.0}, {0.5, 0.8, 0.36363636363636364, 4.0}, {0.9, 0.9, 90.0, 9.0}}) {
        CAPTURE(rho);
        CAPTURE(q);
        const RouletteFurnace furnace{rho, q};
        CHECK(furnace.variance() == near(variance, 1e-12));
        CHECK(furnace.surfaces() - 1 == near(bounces, 1e-12));
        CHECK(furnace.moment(1) == near(furnace.mean(), 1e-12));
        CHECK(furnace.moment(2) - square(furnace.mean()) == near(variance, 1e-10));
        const auto run = run_roulette(furnace, 2);
        CHECK(agrees(run.light, furnace.mean()));
        CHECK(agrees(run.surfaces, furnace.surfaces()));
        const double error = furnace.error_of_variance(RouletteRun::paths);
        CHECK(agrees({run.variance.value, error}, variance));
        CHECK(error < 0.01 * variance);
        CHECK(run.variance.error == near(error, 0.5));  // two estimates of one thing, the first by 64 blocks
        CHECK_FALSE(agrees({run.variance.value, error}, 1.1 * variance));
    }
}

TEST_CASE("moments of a path: where all weights are 1 they are those of a geometric variable") {
    const RouletteFurnace furnace{0.5, 0.5};
    for (int k = 1; k <= 4; ++k) {
        double sum = 0;
        for (int n = 1; n < 200; ++n) sum += std::pow(n, k) * std::pow(0.5, n);
        CHECK(furnace.moment(k) == near(sum, 1e-12));
    }
}

TEST_CASE("roulette that forgets what those who go on count for is found out") {
    Rng     rng{1, 0, 0, 0};
    Running light;
    for (int i = 0; i < RouletteRun::paths; ++i) {
        double sum = 1;
        for (double throughput = 0.5; rng.uniform<double>() < 0.8; throughput *= 0.5) sum += throughput;
        light.add(sum);
    }
    CHECK_FALSE(agrees(estimate_of(light), 2));
}

TEST_CASE("the cliff: the variance is infinite from q = rho^2 downwards, the fourth moment from rho^(4/3)") {
    CHECK(std::isinf(RouletteFurnace{0.9, 0.80}.variance()));
    CHECK(std::isinf(RouletteFurnace{0.9, 0.80}.moment(2)));
    CHECK(std::isfinite(RouletteFurnace{0.9, 0.82}.variance()));
    CHECK(std::isinf(RouletteFurnace{0.9, std::pow(0.9, 4.0 / 3) - 0.001}.moment(4)));
    CHECK(std::isfinite(RouletteFurnace{0.9, std::pow(0.9, 4.0 / 3) + 0.001}.moment(4)));
}

TEST_CASE(
    "the best chance of going on is where variance times cost is least, and rho for noise of one squared "
    "mean") {
    for (const double rho : {0.2, 0.5, 0.9, 0.99}) {
        CHECK(best_survival(rho, 1) == near(rho, 1e-12));
        for (const double noise : {0.1, 1.0, 10.0}) {
            const double q = best_survival(rho, noise), least = roulette_cost({rho, q}, noise);
            CHECK(q > square(rho));
            const double step = 0.1 * std::min(1 - q, q - square(rho));
            CHECK(least < roulette_cost({rho, q + step}, noise));
            CHECK(least < roulette_cost({rho, q - step}, noise));
            CHECK(std::abs(search_survival(rho, noise) - q) <= 1e-4);
        }
    }
    const auto run = run_roulette({0.9, 0.9}, 2, 1);
    CHECK(agrees(run.cost, roulette_cost({0.9, 0.9}, 1)));
    CHECK_FALSE(agrees(run.cost, roulette_cost({0.9, 0.9}, 1.2)));
}

TEST_CASE("runs of roulette are the same for any number of threads") {
    const auto one = run_roulette({0.9, 0.9}, 1);
    for (const int threads : {2, 7}) {
        const auto more = run_roulette({0.9, 0.9}, threads);
        CHECK(more.light.value == one.light.value);
        CHECK(more.variance.error == one.variance.error);
    }
}

TEST_CASE(
    "glass: roulette by what is left of the light ends no path, by the throughput as many as it squeezes") {
    // of a uniform sky's light the share T goes in, and 4/9 of that lives on as 9/4
    double T = 0;
    for (const auto& z : gauss_legendre(256, 0, 1)) T += 2 * z.x * z.weight * (1 - fresnel(z.x, 1.5).mean());
    const Dielectric<double> glass(1.5);
    Rng                      rng{2, 0, 0, 0};
    Running                  by_light, by_throughput, ended, undivided;
    for (int i = 0; i < 1 << 18; ++i) {
        by_light.add(through_glass(glass, Survival::by_light, rng));
        const double L = through_glass(glass, Survival::by_throughput, rng);
        by_throughput.add(L);
        ended.add(L > 0 ? 0 : 1);
        undivided.add(std::min(L, 1.0));  // as if those who go on counted for themselves alone
    }
    CHECK(by_light.mean() == near(1, 1e-12));
    CHECK(by_light.variance() < 1e-24);
    CHECK(agrees(estimate_of(by_throughput), 1));
    CHECK(agrees(estimate_of(ended), T * 5 / 9));
    // E[X^4] = 1 - T + T (4/9) (9/4)^4
    const double variance = 1.25 * T, fourth = 1 - T + T * 11.390625;
    const double centred = fourth - 4 * (1 - T + T * 5.0625) + 6 * (1 - T + T * 2.25) - 3;
    const double error   = std::sqrt((centred - square(variance)) / (1 << 18));
    CHECK(agrees({by_throughput.variance(), error}, variance));
    CHECK_FALSE(agrees({by_throughput.variance(), error}, 1.05 * variance));
    CHECK_FALSE(agrees(estimate_of(undivided), 1));
}

TEST_CASE("light of long paths: the same for any number of threads, and less with each bounce") {
    const auto one = light_of_long_paths(1), seven = light_of_long_paths(7);
    for (std::size_t k = 0; k < LongPaths::limits.size(); ++k) {
        CHECK(one.missing[k].value == seven.missing[k].value);
        CHECK(one.missing[k].value > 0);
        if (k > 0) CHECK(one.missing[k].value < 0.5 * one.missing[k - 1].value);
    }
}
