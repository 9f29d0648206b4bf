/// @file bad_luck.cpp
/// Random numbers that seldom come, and samples that never do: rows S41, S43 and S44.

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <optional>
#include <vector>

#include "math/square.hpp"
#include "near.hpp"
#include "sampling/concentric_disk.hpp"
#include "sampling/hemisphere.hpp"
#include "sampling/piecewise_constant.hpp"
#include "sampling/power_cosine.hpp"
#include "sampling/rejection.hpp"
#include "sampling/rng.hpp"
#include "sampling/sphere.hpp"
#include "sampling/spherical_triangle.hpp"
#include "sampling/triangle_points.hpp"
#include "statistics/running.hpp"

using namespace sr;
using std::numbers::pi;
using test::near;

namespace {

/// A random number that is always 0.
struct Zero {
    template <class T>
    [[nodiscard]] T uniform() const {
        return 0;
    }
};

/// The share of the cube [-1, 1]^d that the unit ball has.
double ball_in_cube(int d) {
    return std::pow(pi, d / 2.0) / (std::pow(2.0, d) * std::tgamma(d / 2.0 + 1));
}

/// A point of the ball in d dimensions.
std::optional<Accepted<std::vector<double>>> in_ball(Rng& rng, std::size_t d, int most_trials) {
    const double volume = std::pow(2.0, double(d));
    return sample_by_rejection(
        rng,
        [d](Rng& random) {
            std::vector<double> p(d);
            for (double& x : p) x = 2 * random.uniform<double>() - 1;
            return p;
        },
        [=](const auto&) { return 1 / volume; }, volume,
        [](const std::vector<double>& p) {
            double squared = 0;
            for (const double x : p) squared += square(x);
            return squared <= 1 ? 1.0 : 0.0;
        },
        most_trials);
}

/// The bin that a search of the cumulative probabilities names, as it is often written.
std::ptrdiff_t bin_by_lower_bound(const std::vector<double>& below, double u) {
    return std::lower_bound(below.begin(), below.end(), u) - below.begin() - 1;
}
std::ptrdiff_t bin_by_upper_bound(const std::vector<double>& below, double u) {
    return std::upper_bound(below.begin(), below.end(), u) - below.begin() - 1;
}

bool finite(const Vector2<float>& p) {
    return std::isfinite(p.x) && std::isfinite(p.y);
}

}  // namespace

TEST_CASE(
    "S41: at 0, at 1/2 and at the largest number below 1, maps of the square have a point and a density") {
    // Shirley and Chiu's angle as it is printed, (pi / 4) b / a, is 0/0 in the middle of the square
    const Vec2 middle{0.5F, 0.5F};
    CHECK(std::isnan(pi / 4 * double((2 * middle.y - 1) / (2 * middle.x - 1))));
    CHECK(sample_concentric_disk(middle, 1.0F) == Vec2{0, 0});
    const SphericalTriangle<float> of({1, 0, 0}, {0, 1, 0}, {0, 0, 1});
    for (const float x : {0.0F, 0.5F, 1 - 0x1p-24F}) {
        for (const float y : {0.0F, 0.5F, 1 - 0x1p-24F}) {
            const Vec2 u{x, y};
            CHECK(finite(sample_concentric_disk(u, 1.0F)));
            CHECK(pdf_disk(sample_concentric_disk(u, 1.0F), 1.0F).value == near(1 / pi, 1e-12));
            CHECK(std::abs(length(sample_uniform_sphere(u)) - 1) <= 3e-7F);
            CHECK(pdf_triangle(sample_triangle(u), 1.0F).value == 1);
            CHECK(of.pdf(of.sample(u)).value == near(2 / pi, 1e-6));
        }
    }
    // xi = 0 accepts what can't come, xi c p <= f = 0, if nothing else is asked
    Zero       zero;
    const auto draw    = [](Zero&) { return 0.25; };
    const auto p       = [](double) { return 1.0; };
    const auto nothing = [](double) { return 0.0; };
    CHECK(zero.uniform<double>() * 2 * p(draw(zero)) <= nothing(0.25));
    CHECK(!sample_by_rejection(zero, draw, p, 2, nothing, 100));
    CHECK(sample_by_rejection(zero, draw, p, 2, p, 100).has_value());
}

TEST_CASE(
    "S43: rejection starves in many dimensions and in narrow lobes; it ends, and says that it found "
    "nothing") {
    struct Row {
        int    d;
        double trials;
    };
    for (const auto& [d, trials] : {Row{2, 1.273}, Row{3, 1.91}, Row{10, 401.5}, Row{20, 4.063e7}})
        CHECK(1 / ball_in_cube(d) == near(trials, 4e-4));
    Rng     rng{51, 0, 0, 0};
    Running in_ten;
    for (int i = 0; i < 1000; ++i) in_ten.add(in_ball(rng, 10, 1'000'000).value().trials);
    CHECK(std::abs(in_ten.mean() - 401.5) <= 5 * in_ten.standard_error());
    for (int i = 0; i < 10; ++i) CHECK(!in_ball(rng, 20, 1000));

    // Phong's lobe of exponent 10^4 from uniform directions: 10001 trials for each
    const double e    = 1e4;
    const auto   lobe = [&](int most_trials) {
        return sample_by_rejection(
              rng,
              [](Rng& random) {
                const double x = random.uniform<double>();
                return sample_uniform_hemisphere(Vector2<double>{x, random.uniform<double>()});
            },
              [](const auto& w) { return pdf_uniform_hemisphere(w).value; }, 2 * pi,
              [e](const auto& w) { return std::pow(w.z, e); }, most_trials);
    };
    Running in_lobe;
    for (int i = 0; i < 200; ++i) in_lobe.add(lobe(10'000'000).value().trials);
    CHECK(std::abs(in_lobe.mean() - 10001) <= 5 * in_lobe.standard_error());
    int found = 0;
    for (int i = 0; i < 100; ++i) found += lobe(10).has_value();
    CHECK(found <= 3);
    // inversion takes one number a coordinate, and each direction is of the lobe: E[z] = (e + 1) / (e + 2)
    Running below;
    for (int i = 0; i < 10'000; ++i)
        below.add(1 - sample_power_cosine(Vector2<double>{rng.uniform<double>(), 0}, e).z);
    CHECK(std::abs(below.mean() - 1 / (e + 2)) <= 5 * below.standard_error());
}

TEST_CASE(
    "S44: a search for u among cumulative probabilities names a bin that can't come, or none; the table "
    "never") {
    const std::vector<double> values{0, 0.5, 0, 0.5}, below{0, 0, 0.5, 0.5, 1};
    CHECK(bin_by_lower_bound(below, 0) == -1);
    CHECK(bin_by_lower_bound(below, 0.5) == 1);
    CHECK(bin_by_upper_bound(below, 0) == 1);
    CHECK(bin_by_upper_bound(below, 0.5) == 3);
    CHECK(bin_by_upper_bound(below, 1) == 4);  // of 0 to 3
    // by the ends of the bins, the first that is at least u: an empty bin again
    CHECK(values[std::size_t(bin_by_lower_bound(below, 0) + 1)] == 0);

    const PiecewiseConstant<double> table(values);
    CHECK(table.bin_of(table.sample(0)) == 1);
    CHECK(table.bin_of(table.sample(0.5)) == 3);
    CHECK(table.bin_of(table.sample(1 - 0x1p-53)) == 3);
    const PiecewiseConstant<float> in_float(std::vector{0.0F, 0.5F, 0.0F, 0.5F, 0.0F});
    CHECK(in_float.bin_of(in_float.sample(1 - 0x1p-24F)) == 3);
    for (int i = 0; i < 1 << 16; ++i) {
        const float u = float(i) * 0x1p-16F;
        REQUIRE(in_float.pdf(in_float.sample(u)) == 2.5);
    }
}
