/// @file inversion_and_rejection.cpp
/// The two general ways to draw from a density, and what each costs: oracles H6 and H7.

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <vector>

#include "math/square.hpp"
#include "near.hpp"
#include "sampled_density.hpp"
#include "sampling/hemisphere.hpp"
#include "sampling/inversion.hpp"
#include "sampling/rejection.hpp"
#include "sampling/rng.hpp"
#include "statistics/running.hpp"
#include "statistics/tests.hpp"

using namespace sr;
using namespace sr::test;
using std::numbers::pi;

namespace {

constexpr double NaN = std::numeric_limits<double>::quiet_NaN();

/// How many trials a uniform point of the cube [-1, 1]^d takes to lie in the ball: their mean, and mean squared
/// deviation from the expected one.
struct Trials {
    Running mean, variance;
};
template <std::size_t d>
Trials trials_of_ball(int draws, double expected) {
    using Point         = std::array<double, d>;
    const double volume = std::pow(2.0, double(d));
    Rng          rng{41, 0, 0, 0};
    Trials       trials;
    for (int i = 0; i < draws; ++i) {
        const auto one = sample_by_rejection(
            rng,
            [](Rng& random) {
                Point p;
                for (double& x : p) x = 2 * random.uniform<double>() - 1;
                return p;
            },
            [&](const Point&) { return 1 / volume; }, volume,
            [](const Point& p) {
                double squared = 0;
                for (const double x : p) squared += x * x;
                return squared <= 1 ? 1.0 : 0.0;
            },
            1'000'000);
        REQUIRE(one);
        trials.mean.add(one->trials);
        trials.variance.add(square(one->trials - expected));
    }
    return trials;
}

/// cos^e, from uniform directions of the hemisphere, whose density 1 / 2 pi times c = 2 pi is an envelope of 1.
auto cosine_lobe(Rng& rng, double e, double c = 2 * pi, int most = 1'000'000) {
    return sample_by_rejection(
        rng, [](Rng& random) { return sample_uniform_hemisphere(square_point<double>(random)); },
        [](const Vector3<double>& w) { return pdf_uniform_hemisphere(w).value; }, c,
        [e](const Vector3<double>& w) { return std::pow(w.z, e); }, most);
}

bool is_mean(const Running& of, double expected) {
    return std::abs(of.mean() - expected) <= 5 * of.standard_error();
}

/// p of a chi-square test of numbers in [0, 1) against a cumulative density.
template <class Draw, class Cdf>
double chance_of_cdf(const Draw& draw, const Cdf& P) {
    constexpr int              draws = 20'000, cells = 32;
    std::vector<std::uint64_t> observed(cells);
    std::vector<double>        expected;
    Rng                        rng{42, 0, 0, 0};
    for (int i = 0; i < draws; ++i)
        ++observed[std::min(std::size_t(draw(rng) * cells), std::size_t{cells - 1})];
    for (int k = 0; k < cells; ++k) expected.push_back(draws * (P((k + 1.0) / cells) - P(double(k) / cells)));
    return chi_square_test(observed, expected).p;
}

}  // namespace

TEST_CASE_TEMPLATE("inversion: x is where P is u, at both ends too, for some ten values of P", T, float,
                   double) {
    const T      rate    = 3;
    const T      end     = 4;
    const T      rest    = std::expm1(-rate * end);
    const auto   P       = [&](T x) { return std::expm1(-rate * x) / rest; };
    const auto   exact   = [&](T u) { return -std::log1p(u * rest) / rate; };
    const double epsilon = double(std::numeric_limits<T>::epsilon());
    Running      evaluations;
    Rng          rng{43, 0, 0, 0};
    for (int i = 0; i < 1000; ++i) {
        const T    u     = rng.uniform<T>();
        const auto found = invert_cdf(P, Interval<T>{0, end}, u);
        REQUIRE(found);
        // P and u are rounded by a few epsilon, x by that over the density
        const double density = double(rate * std::exp(-rate * found->x));
        REQUIRE(std::abs(double(found->x - exact(u))) <= epsilon * (8 / density + 2 * double(end)));
        evaluations.add(found->evaluations);
    }
    CHECK(evaluations.mean() >= 5);
    CHECK(evaluations.mean() <= 15);
    const auto first     = invert_cdf(P, Interval<T>{0, end}, T(0));
    const auto last      = invert_cdf(P, Interval<T>{0, end}, T(1));
    const auto near_last = invert_cdf(P, Interval<T>{0, end}, 1 - std::numeric_limits<T>::epsilon() / 2);
    REQUIRE((first && last && near_last));
    CHECK(first->x == 0);
    CHECK(first->evaluations == 2);
    CHECK(last->x == end);
    CHECK(near_last->x > T(0.9) * end);
    CHECK(near_last->x <= end);
}

TEST_CASE("inversion: none where u is not between the ends' values, or P is NaN") {
    const auto             P = [](double x) { return 0.2 + 0.6 * x; };
    const Interval<double> range{0, 1};
    CHECK(invert_cdf(P, range, 0.5).has_value());
    CHECK(!invert_cdf(P, range, 0.1));
    CHECK(!invert_cdf(P, range, 0.9));
    CHECK(!invert_cdf(P, range, NaN));
    CHECK(!invert_cdf([](double x) { return x < 0.3 ? x : NaN; }, range, 0.2));
    CHECK(!invert_cdf(P, Interval<double>{1, 0}, 0.5));
}

TEST_CASE("inversion: draws follow the cumulative density, and not another") {
    const auto P    = [](double x) { return x * x * (3 - 2 * x); };
    const auto draw = [&](Rng& rng) {
        return invert_cdf(P, Interval<double>{0, 1}, rng.uniform<double>()).value().x;
    };
    CHECK(chance_of_cdf(draw, P) > significance);
    CHECK(chance_of_cdf(draw, [](double x) { return x * x; }) < refused);
    CHECK(chance_of_cdf([](Rng& rng) { return rng.uniform<double>(); }, P) < refused);
}

TEST_CASE("H6: points of a ball by rejection take as many trials as its share of the cube says") {
    struct Row {
        Trials trials;
        double p;
    };
    for (const auto& [trials, p] :
         {Row{trials_of_ball<2>(20'000, 1 / 0.78539816339744831), 0.78539816339744831},
          Row{trials_of_ball<3>(20'000, 1.909859317102744), 0.52359877559829887},
          Row{trials_of_ball<5>(20'000, 1 / 0.16449340668482264), 0.16449340668482264},
          Row{trials_of_ball<10>(2'000, 401.54279645840001), 0.0024903945701927202}}) {
        CAPTURE(p);
        CHECK(is_mean(trials.mean, 1 / p));
        CHECK(is_mean(trials.variance, (1 - p) / square(p)));
    }
    // trials that count the refused ones only are one short; and 2 % more are noticed
    const Trials in_space = trials_of_ball<3>(100'000, 1.909859317102744);
    CHECK(is_mean(in_space.mean, 1.909859317102744));
    CHECK(!is_mean(in_space.mean, 0.909859317102744));
    CHECK(!is_mean(in_space.mean, 1.909859317102744 * 1.02));
    CHECK(is_mean(in_space.variance, 1.7377032940214157));
    CHECK(!is_mean(in_space.variance, 1.7377032940214157 * 1.1));
}

TEST_CASE("H7: a lobe cos^e from uniform directions takes e + 1 trials, and follows its density") {
    for (const double e : {1.0, 10.0, 100.0}) {
        CAPTURE(e);
        Running trials, mean_cosine;
        Rng     rng{44, 0, 0, 0};
        for (int i = 0; i < 100'000; ++i) {
            const auto one = cosine_lobe(rng, e);
            REQUIRE(one);
            trials.add(one->trials);
            mean_cosine.add(one->x.z);
        }
        CHECK(is_mean(trials, e + 1));
        CHECK(!is_mean(trials, 1.02 * (e + 1)));
        CHECK(is_mean(mean_cosine, (e + 1) / (e + 2)));
    }
    // P(z) = z^(e + 1)
    const auto height = [](Rng& rng) { return cosine_lobe(rng, 2.0).value().x.z; };
    CHECK(chance_of_cdf(height, [](double z) { return z * z * z; }) > significance);
    CHECK(chance_of_cdf(height, [](double z) { return z * z; }) < refused);
}

TEST_CASE("rejection: a c twice as large takes twice the trials, and one too small is found out") {
    Running trials;
    Rng     rng{45, 0, 0, 0};
    for (int i = 0; i < 20'000; ++i) trials.add(cosine_lobe(rng, 1, 4 * pi).value().trials);
    CHECK(is_mean(trials, 4));
    const auto with = [&](double c, auto f) {
        return [&rng, c, f] {
            for (int i = 0; i < 100; ++i)
                (void)sample_by_rejection(
                    rng, [](Rng& random) { return random.uniform<double>(); }, [](double) { return 1.0; }, c,
                    f, 100);
        };
    };
    CHECK_NOTHROW(with(2, [](double x) { return 2 * x; })());
    CHECK_THROWS_AS(with(1.9, [](double x) { return 2 * x; })(), std::domain_error);
    CHECK_THROWS_WITH_AS(with(2, [](double) { return 2.5; })(),
                         "rejection: f = 2.5 and c p = 2 at a point drawn; must be 0 <= f <= c p, and finite",
                         std::domain_error);
    CHECK_THROWS_WITH_AS(with(2, [](double) { return -1.0; })(),
                         "rejection: f = -1 and c p = 2 at a point drawn; must be 0 <= f <= c p, and finite",
                         std::domain_error);
    CHECK_THROWS_AS(with(2, [](double) { return NaN; })(), std::domain_error);
    CHECK_THROWS_AS(with(NaN, [](double) { return 1.0; })(), std::domain_error);
    // an envelope that touches f is one, whichever way the two are rounded
    CHECK_NOTHROW(with(3, [](double) { return std::nextafter(3.0, 4.0); })());
}
