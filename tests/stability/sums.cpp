/// @file sums.cpp
/// Sums of very many floats: rows S39, S40 and S55. The naive forms are those that chapter 9 charts.

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

#include "../../chapters/09_monte_carlo/repeated.hpp"
#include "../../chapters/09_monte_carlo/sums.hpp"
#include "catalogue.hpp"
#include "near.hpp"
#include "statistics/running.hpp"

using namespace sr;
using test::near;
using test::within_factor_3;

namespace {

std::vector<float> uniform_numbers(std::uint64_t seed, int n) {
    Rng                rng{seed, 0, 0, 0};
    std::vector<float> values(std::size_t(n), 0.0F);
    for (float& x : values) x = rng.uniform<float>();
    return values;
}

}  // namespace

TEST_CASE(
    "S39: a sum in float of 2^26 samples stays at 2^24; in double, or with what was lost carried on, it does "
    "not") {
    constexpr int n = 1 << 26;
    CHECK(sum_of_ones(n) == 16777216.0F);
    CHECK(sum_of_ones(1 << 24) == 16777216.0F);
    Rng      rng{1, 0, 0, 0};
    float    plain = 0;
    double   exact = 0;
    KahanSum kahan;
    for (int i = 0; i < n; ++i) {
        const float x = rng.uniform<float>();
        plain += x;
        exact += x;
        kahan.add(x);
    }
    CHECK(plain / n == 0.25F);
    CHECK(std::abs(exact / n - 0.5) <= 5 * 3.5e-5);
    CHECK(double(kahan.value()) == near(exact, 1e-7));
    KahanSum ones;
    for (int i = 0; i < n; ++i) ones.add(1);
    CHECK(ones.value() == float(n));
}

TEST_CASE("S40: E[x^2] - E[x]^2 in float of numbers far from 0 is negative, and large") {
    Rng                rng{1, 0, 0, 0};
    std::vector<float> values;
    Running            running;
    double             sum = 0;
    for (int i = 0; i < 1'000'000; ++i) {
        values.push_back(1000 + 0.01F * rng.uniform<float>());
        running.add(values.back());
        sum += values.back();
    }
    const double mean    = sum / 1e6;
    double       squares = 0;
    for (const float x : values) squares += square(x - mean);
    CHECK(double(textbook_variance(values)) == near(-23644.8, 1e-3));
    CHECK(running.variance() == near(squares / (1e6 - 1), 1e-9));
    CHECK(running.variance() == near(8.34e-6, 0.01));  // 1e-4 / 12, and what rounding to float adds
}

TEST_CASE(
    "S55: sums in float depend on their order, and on the number of pieces; blocks of fixed size do not") {
    Running squares;  // of the errors, from the first to the last
    for (std::uint64_t seed = 1; seed <= 16; ++seed) {
        const auto values = uniform_numbers(seed, 1 << 20);
        double     exact  = 0;  // each partial sum is a multiple of 2^-24, below 2^20: no rounding
        for (const float x : values) exact += x;
        const std::set<float> sums{sum_forward(values), sum_backward(values), sum_in_pieces(values, 8),
                                   sum_in_pieces(values, 4), sum_pairwise(values)};
        CHECK(sums.size() >= 4);
        // In pairs, 2^(20 - k) sums are about 2^(k - 1), and rounded to u = 2^(k - 24) or less: by nothing or, as their
        // terms are multiples of u / 2, by u / 2 up or down, a variance of u^2 / 8. Over k = 1 to 20 that adds up to
        // less than 2^-10, a deviation of 1/32; five of them.
        CHECK(std::abs(double(sum_pairwise(values)) - exact) <= 5.0 / 32);
        squares.add(square(double(sum_forward(values)) - exact));
        // Blocks whose size is not that of the threads' shares, merged in their order, are the same for any of them.
        const auto mean_by = [&](int threads) {
            Running all;
            for (const Running& part : repeated(16, threads, [&](std::uint64_t block) {
                     Running of;
                     for (std::size_t i = 0; i < 65536; ++i) of.add(values[block * 65536 + i]);
                     return of;
                 }))
                all.merge(part);
            return all.mean();
        };
        CHECK(mean_by(1) == mean_by(7));
        CHECK(mean_by(1) * (1 << 20) == near(exact, 1e-12));
    }
    CHECK(within_factor_3(std::sqrt(squares.mean()), 524285.434 - 524277.875));
}
