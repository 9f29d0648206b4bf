/// @file statistics.cpp

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>
#include <vector>

#include "sampling/rng.hpp"
#include "statistics/estimate.hpp"
#include "statistics/running.hpp"
#include "statistics/slope.hpp"
#include "statistics/tests.hpp"

using namespace sr;

namespace {

double relative_error(double measured, double expected) {
    return std::abs(measured - expected) / std::abs(expected);
}

Running running(const std::vector<double>& values) {
    Running r;
    for (const double v : values) r.add(v);
    return r;
}

}  // namespace

TEST_CASE("running: a sample whose mean and variance are known") {
    const Running r = running({2, 4, 4, 4, 5, 5, 7, 9});
    CHECK(r.count() == 8);
    CHECK(r.mean() == 5);
    CHECK(relative_error(r.variance(), 32.0 / 7) <= 1e-15);
    CHECK(relative_error(r.standard_error(), std::sqrt(32.0 / 7 / 8)) <= 1e-15);
}

TEST_CASE("running: fewer than two values have no variance") {
    CHECK(std::isnan(Running{}.variance()));
    CHECK(std::isnan(running({3}).standard_error()));
    CHECK(running({3}).mean() == 3);
    CHECK(running({3, 3, 3}).variance() == 0);
}

TEST_CASE("running: parts merge to the whole, also empty ones") {
    Rng     rng{1, 0, 0, 0};
    Running whole, parts;
    for (const int size : {0, 1, 2, 1000, 0, 7}) {
        Running part;
        for (int i = 0; i < size; ++i) {
            const double x = 100 + rng.uniform<double>();
            whole.add(x);
            part.add(x);
        }
        parts.merge(part);
    }
    parts.merge(Running{});
    CHECK(parts.count() == whole.count());
    CHECK(relative_error(parts.mean(), whole.mean()) <= 1e-14);
    CHECK(relative_error(parts.variance(), whole.variance()) <= 1e-12);
}

TEST_CASE("running: the variance of values far from 0, where the textbook formula has no digits left") {
    const int n = 1'000'000;
    Rng       rng{40, 0, 0, 0};
    Running   welford;
    float     sum = 0, sum_of_squares = 0;
    for (int i = 0; i < n; ++i) {
        const double x = 1000 + 0.01 * rng.uniform<double>();
        const auto   f = float(x);
        welford.add(x);
        sum += f;
        sum_of_squares += f * f;
    }
    const double expected = 1e-4 / 12;
    const float  mean     = sum / n;
    const double textbook = sum_of_squares / n - mean * mean;
    // (x - mean)^2 of a uniform x has a variance of 4/5 of its mean squared
    CHECK(relative_error(welford.variance(), expected) <= 4 * std::sqrt(0.8 / n));
    CHECK(relative_error(textbook, expected) >= 1e3);
}

TEST_CASE("slope: a power law is found, without error and with a known one") {
    const std::vector<double> x{1, 10, 100, 1000};
    std::vector<double>       y;
    for (const double v : x) y.push_back(7 * std::pow(v, -0.5));
    const Slope exact = log_log_slope(x, y);
    CHECK(std::abs(exact.value + 0.5) <= 1e-14);
    CHECK(exact.standard_error <= 1e-14);

    // residuals +e, -e, -e, +e leave the slope, and give it the error sqrt(4 e^2 / 2 / S_xx), S_xx = 5 log(10)^2
    const double e = 0.1;
    for (std::size_t i = 0; i < 4; ++i) y[i] *= std::exp(i == 0 || i == 3 ? e : -e);
    const Slope noisy = log_log_slope(x, y);
    CHECK(std::abs(noisy.value + 0.5) <= 1e-14);
    CHECK(relative_error(noisy.standard_error, e * std::sqrt(2.0 / 5) / std::log(10.0)) <= 1e-13);
}

TEST_CASE("slope: its standard error is how far it lies off") {
    Running deviations;
    for (int run = 0; run < 2000; ++run) {
        Rng                 rng{7, run, 0, 0};
        std::vector<double> x, y;
        for (int i = 1; i <= 20; ++i) {
            double noise = 0;  // nearly normal, variance 0.01
            for (int k = 0; k < 12; ++k) noise += 0.1 * (rng.uniform<double>() - 0.5);
            x.push_back(i);
            y.push_back(std::pow(i, 1.5) * std::exp(noise));
        }
        const Slope slope = log_log_slope(x, y);
        deviations.add((slope.value - 1.5) / slope.standard_error);
    }
    // Student's t of 18 degrees: mean 0, variance 18 / 16, whose own relative error is sqrt((kurtosis - 1) / n)
    CHECK(z_test(deviations.mean(), deviations.standard_error(), 0).p > 0.01);
    CHECK(z_test(deviations.variance(), 18.0 / 16 * std::sqrt((3 + 6.0 / 14 - 1) / 2000), 18.0 / 16).p >
          0.01);
}

TEST_CASE("slope: the errors of its points are its own, with three points, too") {
    // S_xx = 2 log(10)^2; only the outer points, which are log(10) away from the mean, move the slope
    const std::vector<double> x{1, 10, 100};
    const Slope outer = log_log_slope(x, std::vector<Estimate>{{3, 0.03}, {300, 50}, {3e4, 600}});
    CHECK(relative_error(outer.value, 2) <= 1e-14);
    CHECK(relative_error(outer.standard_error, std::hypot(0.01, 0.02) / (2 * std::log(10.0))) <= 1e-14);

    // slopes of four points lie off by as much as they say, and not by half of it
    Running squares;
    Rng     rng{5, 0, 0, 0};
    for (int n = 0; n < 400; ++n) {
        std::vector<Estimate> y;
        for (const double at : {1.0, 2.0, 4.0, 8.0}) {
            double noise = -6;  // normal, nearly: twelve uniform numbers
            for (int i = 0; i < 12; ++i) noise += rng.uniform<double>();
            y.push_back({at * std::exp(0.01 * noise), 0.01 * at});
        }
        const Slope  of  = log_log_slope(std::vector<double>{1, 2, 4, 8}, y);
        const double off = (of.value - 1) / of.standard_error;
        squares.add(off * off);
    }
    CHECK(z_test(squares.mean(), squares.standard_error(), 1).p > 0.01);
    CHECK(z_test(squares.mean() / 4, squares.standard_error() / 4, 1).p < 1e-6);
}

TEST_CASE("slope: what has none is refused") {
    const std::vector<double> three{1, 2, 3};
    CHECK_THROWS_AS(static_cast<void>(log_log_slope(std::vector<double>{1, 2}, std::vector<double>{1, 2})),
                    std::invalid_argument);
    CHECK_THROWS_AS(static_cast<void>(log_log_slope(three, std::vector<double>{1, 2})),
                    std::invalid_argument);
    CHECK_THROWS_AS(static_cast<void>(log_log_slope(three, std::vector<double>{1, 0, 1})),
                    std::invalid_argument);
    CHECK_THROWS_AS(static_cast<void>(log_log_slope(three, std::vector<double>{1, std::nan(""), 1})),
                    std::invalid_argument);
    CHECK_THROWS_AS(static_cast<void>(log_log_slope(std::vector<double>{2, 2, 2}, three)),
                    std::invalid_argument);
    const double nan = std::nan("");
    for (const double error : {-1.0, nan, HUGE_VAL})
        CHECK_THROWS_AS(
            static_cast<void>(log_log_slope(three, std::vector<Estimate>{{1, 0}, {2, error}, {3, 0}})),
            std::invalid_argument);
    CHECK_THROWS_AS(static_cast<void>(log_log_slope(three, std::vector<Estimate>{{1, 0}, {nan, 0}, {3, 0}})),
                    std::invalid_argument);
}

TEST_CASE("z test: quantiles of the normal distribution") {
    CHECK(std::abs(z_test(1.959963984540054, 1, 0).p - 0.05) <= 1e-15);
    CHECK(std::abs(z_test(2 - 0.25 * 2.5758293035489004, 0.25, 2).p - 0.01) <= 1e-15);
    CHECK(z_test(3, 1, 3).p == 1);
    CHECK_THROWS_AS(static_cast<void>(z_test(1, 0, 1)), std::invalid_argument);
    CHECK_THROWS_AS(static_cast<void>(z_test(1, std::nan(""), 1)), std::invalid_argument);
}

TEST_CASE("chi-square: the survival function at published quantiles") {
    struct Quantile {
        int    degrees;
        double x, p;
    };
    for (const Quantile q : {Quantile{1, 3.841458820694124, 0.05}, Quantile{2, 5.991464547107979, 0.05},
                             Quantile{3, 7.814727903251179, 0.05}, Quantile{10, 18.307038053275146, 0.05},
                             Quantile{100, 124.34211340400407, 0.05}, Quantile{1, 6.634896601021213, 0.01}}) {
        CAPTURE(q.degrees);
        CHECK(relative_error(chi_square_survival(q.x, q.degrees), q.p) <= 1e-12);
    }
}

TEST_CASE("chi-square: the survival function at its ends, and where a power series would overflow") {
    for (const int k : {1, 2, 3, 10, 999}) CHECK(chi_square_survival(0, k) == 1);
    CHECK(chi_square_survival(std::numeric_limits<double>::infinity(), 5) == 0);
    CHECK_THROWS_AS(static_cast<void>(chi_square_survival(-1, 5)), std::invalid_argument);
    CHECK_THROWS_AS(static_cast<void>(chi_square_survival(std::nan(""), 5)), std::invalid_argument);
    CHECK_THROWS_AS(static_cast<void>(chi_square_survival(1, 0)), std::invalid_argument);

    // Wilson and Hilferty: (X / k)^(1/3) is nearly normal, with mean 1 - 2/(9k) and variance 2/(9k)
    for (const int k : {500, 999, 5000, 100001}) {
        for (const double z : {-2.0, 0.0, 1.0, 3.0}) {
            CAPTURE(k);
            CAPTURE(z);
            const double v = 2.0 / 9 / k;
            const double x = k * std::pow(1 - v + z * std::sqrt(v), 3);
            CHECK(std::abs(chi_square_survival(x, k) - std::erfc(z / std::sqrt(2.0)) / 2) <= 2e-4);
        }
    }
}

TEST_CASE("chi-square: a sample worked out by hand") {
    const std::array<std::uint64_t, 4> observed{18, 22, 30, 10};
    const std::array<double, 4>        expected{20, 20, 20, 20};
    const ChiSquare                    test = chi_square_test(observed, expected);
    CHECK(relative_error(test.statistic, (4 + 4 + 100 + 100) / 20.0) <= 1e-15);
    CHECK(test.degrees == 3);
    CHECK(test.p == chi_square_survival(test.statistic, 3));
}

TEST_CASE("chi-square: small expectations are pooled, impossible counts are not chance") {
    const std::array<std::uint64_t, 5> observed{48, 1, 2, 0, 49};
    const ChiSquare test = chi_square_test(observed, std::array{47.0, 2.0, 1.5, 1.5, 48.0});
    CHECK(test.degrees == 2);  // the cells are {1.5 + 1.5 + 2, 47, 48}
    CHECK(relative_error(test.statistic, 4 / 5.0 + 1 / 47.0 + 1 / 48.0) <= 1e-14);

    const ChiSquare impossible =
        chi_square_test(std::array<std::uint64_t, 3>{1, 50, 49}, std::array{0.0, 50.0, 50.0});
    CHECK(impossible.p == 0);
    const ChiSquare nothing =
        chi_square_test(std::array<std::uint64_t, 3>{0, 50, 50}, std::array{0.0, 50.0, 50.0});
    CHECK(nothing.p == 1);
}

TEST_CASE("chi-square: counts that don't belong to the expectation are refused") {
    const std::array<std::uint64_t, 2> observed{10, 20};
    CHECK_THROWS_AS(static_cast<void>(chi_square_test(observed, std::array{30.0})), std::invalid_argument);
    CHECK_THROWS_AS(static_cast<void>(chi_square_test(observed, std::array{0.3, 0.7})),
                    std::invalid_argument);
    CHECK_THROWS_AS(static_cast<void>(chi_square_test(observed, std::array{40.0, -10.0})),
                    std::invalid_argument);
    CHECK_THROWS_AS(static_cast<void>(chi_square_test(observed, std::array{30.0, std::nan("")})),
                    std::invalid_argument);
    CHECK_THROWS_AS(
        static_cast<void>(chi_square_test(std::array<std::uint64_t, 2>{2, 2}, std::array{2.0, 2.0})),
        std::invalid_argument);
}

TEST_CASE("a share's error is Laplace's: not 0 where nothing was seen, nor where all was") {
    const double error = std::sqrt(0.01 * 0.99 / 98);  // of one in a hundred
    for (const auto& [count, value] : {std::pair{0, 0.0}, {98, 1.0}}) {
        CHECK(share(count, 98).value == value);
        CHECK(relative_error(share(count, 98).error, error) <= 1e-15);
        CHECK(percent(share(count, 98)).value == 100 * value);
        CHECK(relative_error(percent(share(count, 98)).error, 100 * error) <= 1e-15);
    }
}

TEST_CASE("shares and medians scatter by their standard errors") {
    constexpr int samples = 400, repeats = 4000;
    Running       shares, share_errors, medians, median_errors;
    for (int i = 0; i < repeats; ++i) {
        Rng                 rng{31, i, 0, 0};
        std::vector<double> values;
        int                 count = 0;
        for (int k = 0; k < samples; ++k) {
            values.push_back(rng.uniform<double>());
            count += values.back() < 0.2 ? 1 : 0;
        }
        const Estimate s = share(count, samples), m = median(values);
        shares.add(s.value);
        share_errors.add(s.error);
        medians.add(m.value);
        median_errors.add(m.error);
    }
    // A share p scatters by sqrt(p (1 - p) / n), the median of uniform numbers by sqrt(1 / 4 n); a scatter that is
    // seen 4000 times is known to 1.1 %, of which this is five times as much.
    const double of_share = std::sqrt(0.2 * 0.8 / samples), of_median = 0.5 / std::sqrt(samples);
    CHECK(relative_error(std::sqrt(shares.variance()), of_share) <= 0.056);
    CHECK(relative_error(share_errors.mean(), of_share) <= 0.01);
    CHECK(relative_error(std::sqrt(medians.variance()), of_median) <= 0.056);
    CHECK(relative_error(median_errors.mean(), of_median) <= 0.02);
}
