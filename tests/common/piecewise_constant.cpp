/// @file piecewise_constant.cpp
/// Tables of one and two dimensions, drawn from.

#include "sampling/piecewise_constant.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numeric>
#include <vector>

#include "near.hpp"
#include "refusal.hpp"
#include "sampled_density.hpp"
#include "sampling/rng.hpp"
#include "sampling/unit_interval.hpp"
#include "statistics/tests.hpp"

using namespace sr;
using namespace sr::test;

namespace {

/// The unit square as it is.
auto plain_chart() {
    const auto same = [](const Vector2<double>& s) { return s; };
    return DomainMap{same, same, [](const Vector2<double>&) { return 1.0; }};
}

/// p of a chi-square test of draws from one table against another's values.
double chance_of_values(const std::vector<double>& drawn, const std::vector<double>& stated) {
    constexpr int                   draws = 100'000;
    const PiecewiseConstant<double> table(drawn);
    std::vector<std::uint64_t>      observed(drawn.size());
    std::vector<double>             expected(stated);
    Rng                             rng{31, 0, 0, 0};
    for (int i = 0; i < draws; ++i) ++observed[table.bin_of(table.sample(rng.uniform<double>()))];
    const double sum = std::accumulate(stated.begin(), stated.end(), 0.0);
    for (double& cell : expected) cell *= draws / sum;
    return chi_square_test(observed, expected).p;
}

}  // namespace

TEST_CASE_TEMPLATE("table: sample and invert undo each other, and no bin of value 0 is drawn", T, float,
                   double) {
    std::vector<T> lone(1000, T(0));
    lone[617] = T(1e-30);
    for (const auto& values : {std::vector<T>{0, T(0.5), 0, T(0.5)},
                               {1, 2, 0, 3, 4},
                               {0, 0, 1},
                               {7},
                               {1, 0},
                               std::vector<T>(49, T(0.1)),
                               lone}) {
        const PiecewiseConstant<T> table(values);
        const auto                 try_with = [&](T u) {
            const T x = table.sample(u);
            REQUIRE(x >= 0);
            REQUIRE(x < 1);
            REQUIRE(values[table.bin_of(x)] > 0);
            REQUIRE(table.pdf(x) > 0);
            REQUIRE(std::abs(double(table.invert(x)) - double(u)) <=
                                    double(std::numeric_limits<T>::epsilon()) * (1 + table.pdf(x)));
        };
        for (const T u : {T(0), largest_below_1<T>}) try_with(u);
        for (int i = 0; i < 4096; ++i) try_with(T(i) / 4096);
        Rng rng{32, 0, 0, 0};
        for (int i = 0; i < 4096; ++i) try_with(rng.uniform<T>());
        CHECK(table.pdf(T(-1e-6)) == 0);
        CHECK(table.pdf(T(1)) == 0);
        double sum = 0;
        for (std::size_t bin = 0; bin < values.size(); ++bin) sum += table.probability(bin);
        CHECK(sum == near(1, 1e-13));
    }
}

TEST_CASE_TEMPLATE(
    "table: a bin's first number and its last are its own, which the product x n alone mistakes", T, float,
    double) {
    int mistaken = 0;
    for (std::size_t n = 1; n <= 300; ++n) {
        const PiecewiseConstant<T> table(std::vector<T>(n, T(1)));
        for (std::size_t bin = 0; bin < n; ++bin) {
            const T first = T(bin) / T(n), last = std::nextafter(T(bin + 1) / T(n), T(0));
            REQUIRE(table.bin_of(first) == bin);
            REQUIRE(table.bin_of(last) == bin);
            mistaken += std::size_t(first * T(n)) != bin;
            mistaken += std::size_t(last * T(n)) != bin;
        }
    }
    CHECK(mistaken > 100);
}

TEST_CASE("table: the density is the values', and draws follow it; another table's they don't") {
    const PiecewiseConstant<double> table(std::vector{1.0, 2.0, 0.0, 3.0, 4.0});
    CHECK(table.sum() == 10);
    CHECK(table.pdf(0.1) == near(0.5));
    CHECK(table.pdf(0.5) == 0);
    CHECK(table.pdf(0.9) == near(2));
    CHECK(table.sample(0.3) == near(0.6));  // where the first two bins, and the empty one, are behind
    CHECK(table.sample(0.8) == near(0.9));
    CHECK(table.invert(0.7) == near(0.45));
    CHECK(chance_of_values({1, 2, 0, 3, 4}, {1, 2, 0, 3, 4}) > significance);
    CHECK(chance_of_values({1, 2, 0, 3, 4}, {1, 2, 0, 3.1, 3.9}) < refused);
    CHECK(chance_of_values({1, 2, 0, 3, 4}, {1, 0, 2, 3, 4}) < refused);
}

TEST_CASE("table: values that no density has are refused by their place") {
    const auto NaN  = std::numeric_limits<double>::quiet_NaN();
    const auto made = [](const std::vector<double>& values) {
        return refusal_of([&] { (void)PiecewiseConstant<double>(values); });
    };
    CHECK(made({1, 2}) == "accepted");
    CHECK(made({1, -2, 3}) == "table: value 1 is -2; must be finite and not negative");
    CHECK(made({1, 2, NaN}) == "table: value 2 is nan; must be finite and not negative");
    CHECK(made({HUGE_VAL}) == "table: value 0 is inf; must be finite and not negative");
    CHECK(made({0, 0}) == "table: its values add up to 0; must be positive and finite");
    CHECK(made({}) == "table: its values add up to 0; must be positive and finite");
    CHECK(made({1e308, 1e308}) == "table: its values add up to inf; must be positive and finite");

    const auto made_2d = [](const std::vector<double>& values, std::size_t width) {
        return refusal_of([&] { (void)PiecewiseConstant2D<double>(values, width); });
    };
    CHECK(made_2d({1, 2, 3, 4}, 2) == "accepted");
    CHECK(made_2d({1, 2, 3, NaN}, 2) == "row 1 of a table: value 1 is nan; must be finite and not negative");
    CHECK(made_2d({0, 0, -1, 0}, 2) == "row 1 of a table: value 0 is -1; must be finite and not negative");
    CHECK(made_2d({0, 0, 0, 0}, 2) == "table: its values add up to 0; must be positive and finite");
    CHECK(made_2d({1, 2, 3}, 2) == "table: 3 values can't be rows of 2");
    CHECK(made_2d({1, 2, 3}, 0) == "table: 3 values can't be rows of 0");
}

TEST_CASE_TEMPLATE(
    "table of two dimensions: sample and invert undo each other, and no bin of value 0 is drawn", T, float,
    double) {
    const std::vector<T>         values{0, 1, 0, 2,  //
                                0, 0, 0, 0,  //
                                3, 0, 0, 1};
    const PiecewiseConstant2D<T> table(values, 4);
    const auto                   try_with = [&](const Vector2<T>& u) {
        const auto p      = table.sample(u);
        const auto back   = table.invert(p);
        const auto row    = p.y < T(1) / 3 ? 0U : p.y < T(2) / 3 ? 1U : 2U;
        const auto column = std::size_t(4 * p.x);
        REQUIRE(p.x < 1);
        REQUIRE(p.y < 1);
        REQUIRE(table.pdf(p) == near(double(values[4 * row + column]) * 12 / 7, 1e-6));
        REQUIRE(std::abs(double(back.x - u.x)) <= 8 * double(std::numeric_limits<T>::epsilon()));
        REQUIRE(std::abs(double(back.y - u.y)) <= 8 * double(std::numeric_limits<T>::epsilon()));
    };
    for (const T x : {T(0), T(0.25), T(0.75), largest_below_1<T>})
        for (const T y : {T(0), T(3) / 7, T(0.5), largest_below_1<T>}) try_with({x, y});
    Rng rng{33, 0, 0, 0};
    for (int i = 0; i < 4096; ++i) try_with(square_point<T>(rng));
    CHECK(table.pdf({T(0.9), T(0.5)}) == 0);
    CHECK(table.pdf({T(0.9), T(1)}) == 0);
    CHECK(table.pdf({T(-0.1), T(0.1)}) == 0);
}

TEST_CASE("table of two dimensions: draws follow the table; not where x does not know of y") {
    const std::vector<double>         values{0, 1, 0, 2, 0, 0, 0, 0, 3, 0, 0, 1, 1, 1, 1, 1};
    const PiecewiseConstant2D<double> table(values, 4);
    const auto                        pdf = [&](const Vector2<double>& p) { return table.pdf(p); };
    CHECK(integral(plain_chart(), pdf) == near(1, 1e-12));
    CHECK(chance_of_density(
              plain_chart(), [&](Rng& rng) { return table.sample(square_point<double>(rng)); }, pdf) >
          significance);
    const PiecewiseConstant<double> columns(std::vector{4.0, 2.0, 1.0, 4.0}),
        rows(std::vector{3.0, 0.0, 4.0, 4.0});
    const auto apart = [&](Rng& rng) {
        const auto u = square_point<double>(rng);
        return Vector2<double>{columns.sample(u.x), rows.sample(u.y)};
    };
    CHECK(chance_of_density(plain_chart(), apart, pdf) < refused);
}
