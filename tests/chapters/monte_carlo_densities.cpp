/// @file monte_carlo_densities.cpp
/// Section 9.5: means and variances of its estimates are those of the oracles H5, H13, H14, H20 and H21, within five
/// standard errors of 2^18 samples (significance 6e-7 each), seeds fixed.

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>
#include <tuple>

#include "../../chapters/09_monte_carlo/control_variate.hpp"
#include "../../chapters/09_monte_carlo/moments.hpp"
#include "../../chapters/09_monte_carlo/overhead_lamp.hpp"
#include "../../chapters/09_monte_carlo/power_density.hpp"
#include "../../chapters/09_monte_carlo/square_lamp.hpp"
#include "../../chapters/09_monte_carlo/two_densities.hpp"
#include "../../chapters/09_monte_carlo/two_lamps.hpp"
#include "near.hpp"

using namespace sr;
using test::near;

namespace {

/// Five standard errors, and rounding where there is no error.
bool agrees(Estimate estimate, double exact) {
    return std::abs(estimate.value - exact) <= 5 * estimate.error + 1e-14 * std::abs(exact);
}

template <class Draw>
Moments check_moments(const Draw& draw, double mean, double variance) {
    const auto seen = moments_of(1, draw);
    CHECK(agrees(seen.mean, mean));
    CHECK(std::abs(seen.variance.value - variance) <= 5 * seen.variance.error + 1e-13);
    return seen;
}

}  // namespace

TEST_CASE("H13: x^2 by powers of x") {
    for (const auto& [a, variance] :
         {std::tuple{1.0, 4.0 / 45}, {2.0, 1.0 / 72}, {3.0, 0.0}, {4.0, 1.0 / 72}}) {
        CAPTURE(a);
        CHECK(std::abs(variance_of_square(a) - variance) <= 1e-15);
        check_moments([power = a](Rng& rng) { return draw_square({power}, rng); }, 1.0 / 3, variance);
        // drawn with another power than it is divided by, or by a density 2 % too large
        const auto wrong = [power = a](Rng& rng) {
            return square_over_pdf({power}, PowerDensity{power + 0.1}.sample(rng.uniform<double>()));
        };
        const auto scaled = [power = a](Rng& rng) { return draw_square({power}, rng) / 1.02; };
        if (a != 3) CHECK_FALSE(agrees(moments_of(1, wrong).mean, 1.0 / 3));  // f / p is the same everywhere
        CHECK_FALSE(agrees(moments_of(1, scaled).mean, 1.0 / 3));
    }
    CHECK(std::isfinite(square_over_pdf({4}, PowerDensity{4}.sample(0))));
    CHECK(std::isfinite(square_over_pdf({4}, PowerDensity{4}.sample(1 - 0x1p-53))));
}

TEST_CASE("H14: two densities at once are better than the worse one and worse than the better one") {
    const double mean = 1.0 / 3;
    CHECK(variance_weighed(Heuristic::balance) == near(0.018721058606716604, 1e-12));
    CHECK(variance_weighed(Heuristic::power) == near(0.018175986775525456, 1e-12));
    CHECK(variance_mixed() == near(0.040885490263979078, 1e-12));
    for (const auto heuristic : {Heuristic::balance, Heuristic::power})
        check_moments([=](Rng& rng) { return draw_weighed_square(heuristic, rng); }, mean,
                      variance_weighed(heuristic));
    check_moments(draw_mixed_square, mean, 0.040885490263979078);
    // weights that don't add up to 1: each is taken for the density of the other
    const auto wrong = [](Rng& rng) {
        const double u = rng.uniform<double>(), x = std::sqrt(1 - rng.uniform<double>());
        return weight_of(Heuristic::balance, 2 * u, 1) * u * u +
               weight_of(Heuristic::balance, 2 * x, 1) * x / 2;
    };
    CHECK_FALSE(agrees(moments_of(1, wrong).mean, mean));
}

TEST_CASE("H20: a control variate takes away what it knows") {
    const double mean = std::numbers::e - 1, best = ExponentialLessLine::best();
    CHECK(best == near(1.6903090292457286, 1e-14));
    for (const auto& [beta, variance] :
         {std::tuple{0.0, 0.24203560745276536}, {1.0, 0.043650769245143926}, {best, 0.0039402229236289119}}) {
        CAPTURE(beta);
        const ExponentialLessLine less{beta};
        CHECK(less.variance() == near(variance, 1e-12));
        check_moments([=](Rng& rng) { return less.draw(rng); }, mean, variance);
    }
    const auto without_its_integral = [](Rng& rng) { return ExponentialLessLine{1}.draw(rng) - 0.02 * 1.5; };
    CHECK_FALSE(agrees(moments_of(1, without_its_integral).mean, mean));
}

TEST_CASE("H21: of two lamps, one is chosen") {
    for (const auto& [chance, variance] : {std::tuple{0.5, 64.0}, {0.9, 0.0}, {0.1, 711.11111111111111}}) {
        CAPTURE(chance);
        const TwoLamps lamps{chance};
        CHECK(std::abs(lamps.variance() - variance) <= 1e-12);
        check_moments([=](Rng& rng) { return lamps.draw(rng); }, 10, variance);
    }
    CHECK_FALSE(agrees(moments_of(1, [](Rng& rng) { return TwoLamps{0.9}.draw(rng) * 1.02; }).mean, 10));
}

TEST_CASE("H5: a disk overhead by area, by solid angle, by the cosine, and by two at once") {
    for (const auto& [h, mean, variance] : {std::tuple{1.0, 1.5707963267948966, 0.41123351671205661},
                                            {0.5, 2.5132741228718346, 6.7376499378103355},
                                            {0.1, 3.1104877758314785, 319.31135985468837}}) {
        CAPTURE(h);
        const OverheadLamp lamp(h);
        CHECK(lamp.deviation_by_area() == near(std::sqrt(variance) / mean, 1e-12));
        const auto by = [&](auto way) { return [&, way](Rng& rng) { return (lamp.*way)(draw_pair(rng)); }; };
        check_moments(by(&OverheadLamp::by_area), 1, square(lamp.deviation_by_area()));
        check_moments(by(&OverheadLamp::by_solid_angle), 1, square(lamp.deviation_by_solid_angle()));
        check_moments(by(&OverheadLamp::by_cosine), 1, square(lamp.deviation_by_cosine()));
        for (const auto heuristic : {Heuristic::balance, Heuristic::power}) {
            const auto both = moments_of(2, [&](Rng& rng) {
                const auto u = draw_pair(rng), v = draw_pair(rng);
                return lamp.by_both(heuristic, u, v);
            });
            CHECK(agrees(both.mean, 1));
            CHECK(2 * both.variance.value <= 1);
        }
    }
    const OverheadLamp lamp(1), lower(0.98);  // a lamp that is sampled where it is not
    CHECK_FALSE(agrees(
        moments_of(1, [&](Rng& rng) { return lower.by_area(draw_pair(rng)) * 2 / (1 + 0.98 * 0.98); }).mean,
        1));
}

TEST_CASE("section 9.5: a square lamp by five densities") {
    const SquareLamp lamp;
    const auto       agree = [&](const auto& draw) {
        return agrees(moments_of(1, draw).mean, SquareLamp::exact());
    };
    for (const auto way : {&SquareLamp::by_uniform, &SquareLamp::by_cosine, &SquareLamp::by_area,
                           &SquareLamp::by_solid_angle}) {
        CHECK(agree([&](Rng& rng) { return (lamp.*way)(draw_pair(rng)); }));
        CHECK_FALSE(agree([&](Rng& rng) { return (lamp.*way)(draw_pair(rng)) / 1.05; }));
    }
    CHECK(agree([&](Rng& rng) {
        const auto u = draw_pair(rng), v = draw_pair(rng);
        return lamp.by_both(u, v);
    }));
}
