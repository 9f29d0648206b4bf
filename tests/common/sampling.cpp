/// @file sampling.cpp

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <set>
#include <vector>

#include "math/extremes.hpp"
#include "sampling/hemisphere.hpp"
#include "sampling/linear.hpp"
#include "sampling/rng.hpp"
#include "statistics/running.hpp"
#include "statistics/tests.hpp"

using namespace sr;

namespace {

constexpr double alpha = 0.001;  // significance of each test here; seeds are fixed

/// Chi-square test of numbers in [0, 1] for uniformity, with 64 cells.
double uniformity(const std::vector<double>& numbers) {
    std::vector<std::uint64_t> observed(64);
    for (const double u : numbers) ++observed.at(std::min(std::size_t(u * 64), std::size_t{63}));
    const std::vector<double> expected(64, double(numbers.size()) / 64);
    return chi_square_test(observed, expected).p;
}

/// p-value of Pearson's correlation of neighbours in the row; under independence its variance is 1 / n.
double correlation_p(const std::vector<double>& numbers) {
    Running all;
    for (const double u : numbers) all.add(u);
    double covariance = 0;
    for (std::size_t i = 1; i < numbers.size(); ++i) {
        covariance += (numbers[i] - all.mean()) * (numbers[i - 1] - all.mean());
    }
    const auto n = double(numbers.size() - 1);
    return z_test(covariance / n / all.variance(), 1 / std::sqrt(n), 0).p;
}

/// The first number of 10 000 generators, made by make(0), make(1), ...
template <class Make>
std::vector<double> first_numbers(Make make) {
    std::vector<double> numbers;
    for (int i = 0; i < 10'000; ++i) numbers.push_back(make(i).template uniform<double>());
    return numbers;
}

/// The generator that one should not seed with a pixel's index: Lewis, Goodman and Miller's minimal standard.
struct MinimalStandard {
    std::uint64_t state;

    template <class T>
    T uniform() {
        state = 16807 * state % 2147483647;
        return T(state) / T{2147483647};
    }
};

}  // namespace

TEST_CASE("rng: PCG32's published numbers, initial state 42, stream 54") {
    Rng rng{42, 54};
    for (const std::uint32_t expected :
         {0xa15c02b7u, 0x7b47f409u, 0xba1d3330u, 0x83d2f293u, 0xbfa4784bu, 0xcbed606eu}) {
        CHECK(rng.next_u32() == expected);
    }
}

TEST_CASE("rng: a sample can be replayed, and a copy goes on as the original does") {
    Rng rng{1, 2, 3, 4};
    rng.next_u32();
    Rng copy = rng;
    CHECK(copy == rng);
    for (int i = 0; i < 10; ++i) CHECK(copy.next_u32() == rng.next_u32());
    CHECK(Rng{1, 2, 3, 4} == Rng{1, 2, 3, 4});
}

TEST_CASE("rng: every one of seed, x, y and sample makes another sequence, also exchanged") {
    std::set<std::array<std::uint32_t, 2>> starts;
    for (std::uint64_t seed = 0; seed < 8; ++seed) {
        for (int x = 0; x < 8; ++x) {
            for (int y = 0; y < 8; ++y) {
                for (int sample = 0; sample < 8; ++sample) {
                    Rng        rng{seed, x, y, sample};
                    const auto first  = rng.next_u32();
                    const auto second = rng.next_u32();
                    starts.insert({first, second});
                }
            }
        }
    }
    CHECK(starts.size() == 8 * 8 * 8 * 8);
}

TEST_CASE("rng: numbers are uniform, in float and in double") {
    Rng                 rng{5, 0, 0, 0};
    std::vector<double> of_float, of_double, squared;
    for (int i = 0; i < 100'000; ++i) {
        of_float.push_back(double(rng.uniform()));
        of_double.push_back(rng.uniform<double>());
        squared.push_back(of_double.back() * of_double.back());
    }
    CHECK(uniformity(of_float) > alpha);
    CHECK(uniformity(of_double) > alpha);
    CHECK(correlation_p(of_float) > alpha);
    CHECK(correlation_p(of_double) > alpha);
    CHECK(uniformity(squared) < 1e-6);
}

TEST_CASE("rng: the largest draw stays below 1, which x * 2^-32 in float doesn't") {
    CHECK(float(0xffffffffu) * 0x1p-32F == 1.0F);
    CHECK(float(0xffffffffu >> 8) * 0x1p-24F == 1 - 0x1p-24F);

    Rng   rng{6, 0, 0, 0};
    float least = 1, largest = 0;
    for (int i = 0; i < 50'000'000; ++i) {
        const float u = rng.uniform();
        least         = min_or_nan(least, u);
        largest       = max_or_nan(largest, u);
    }
    CHECK(least >= 0);
    CHECK(largest < 1);
    CHECK(largest >= 1 - 0x1p-22F);
}

TEST_CASE("rng: neighbouring pixels, samples and seeds are independent") {
    const auto in_x      = first_numbers([](int i) { return Rng{12345, i, 0, 0}; });
    const auto in_y      = first_numbers([](int i) { return Rng{12345, 0, i, 0}; });
    const auto in_sample = first_numbers([](int i) { return Rng{12345, 0, 0, i}; });
    const auto in_seed   = first_numbers([](int i) { return Rng{std::uint64_t(i), 0, 0, 0}; });
    for (const auto& numbers : {in_x, in_y, in_sample, in_seed}) {
        CHECK(uniformity(numbers) > alpha);
        CHECK(correlation_p(numbers) > alpha);
    }

    const auto seeded_with_index =
        first_numbers([](int i) { return MinimalStandard{12345 + std::uint64_t(i)}; });
    CHECK(uniformity(seeded_with_index) < 1e-6);
    CHECK(correlation_p(seeded_with_index) < 1e-6);
}

TEST_CASE("rng: the mean of an image comes closer with its pixels, which the same seed everywhere prevents") {
    Running honest, same;
    for (int x = 0; x < 10'000; ++x) {
        Rng own{51, x, 0, 0};
        Rng shared{51, 0, 0, 0};
        for (int i = 0; i < 16; ++i) {
            honest.add(own.uniform<double>());
            same.add(shared.uniform<double>());
        }
    }
    const double sigma = std::sqrt(1.0 / 12 / 160'000);
    CHECK(z_test(honest.mean(), sigma, 0.5).p > alpha);
    CHECK(z_test(same.mean(), sigma, 0.5).p < 1e-6);
}

TEST_CASE(
    "hemisphere: directions are of unit length and above the plane, also for the largest number below 1") {
    const float largest = 1 - 0x1p-24F;
    for (const float u : {0.0F, 0.5F, largest}) {
        for (const float v : {0.0F, 0.25F, 0.7F, largest}) {
            const Vec3 w = sample_cosine_hemisphere(Vec2{u, v});
            CHECK(std::abs(length(w) - 1) <= 3e-7F);
            CHECK(w.z >= 0x1p-12F);
        }
    }
    CHECK(sample_cosine_hemisphere(Vec2{0, 0}) == Vec3{0, 0, 1});
}

TEST_CASE(
    "linear: numbers follow their density, at 0 on one side too, and the map is undone by its inverse") {
    for (const auto& [a, b] : {std::pair{1.0, 3.0}, {0.0, 2.0}, {2.0, 0.0}}) {
        CAPTURE(a);
        Rng                        rng{12, 0, 0, 0};
        std::vector<std::uint64_t> observed(16);
        std::vector<double>        expected(16);
        const int                  count = 100'000;
        for (int i = 0; i < count; ++i) {
            const double u = rng.uniform<double>(), x = sample_linear(u, a, b);
            CHECK(std::abs(invert_linear(x, a, b) - u) <= 1e-15);
            ++observed.at(std::min(std::size_t(x * 16), std::size_t{15}));
        }
        // of a linear density, a cell's share is its width times the density in its middle
        for (std::size_t k = 0; k < 16; ++k)
            expected[k] = count / 16.0 * pdf_linear((double(k) + 0.5) / 16, a, b);
        CHECK(chi_square_test(observed, expected).p > alpha);
        for (std::size_t k = 0; k < 16; ++k)
            expected[k] = count / 16.0 * pdf_linear((double(k) + 0.5) / 16, b + 0.1, a + 0.1);
        CHECK(chi_square_test(observed, expected).p < 1e-6);
    }
    CHECK(sample_linear(0.0, 0.0, 1.0) == 0);
    CHECK(sample_linear(1.0F, 0.0F, 1.0F) == 1);
    CHECK(pdf_linear(0.25, 1.0, 3.0) == 0.75);
    CHECK(pdf_linear(-0.1, 1.0, 3.0) == 0);
    CHECK(pdf_linear(1.1, 1.0, 3.0) == 0);
}

TEST_CASE("hemisphere: directions follow the cosine") {
    Rng                 rng{9, 0, 0, 0};
    std::vector<double> z, z_squared, angle;
    for (int i = 0; i < 100'000; ++i) {
        const float u = rng.uniform();
        const float v = rng.uniform();
        const Vec3  w = sample_cosine_hemisphere(Vec2{u, v});
        z.push_back(double(w.z));
        z_squared.push_back(z.back() * z.back());
        const double phi = std::atan2(double(w.y), double(w.x));
        angle.push_back(phi / (2 * std::numbers::pi) + 0.5);
    }
    // the share of directions above z is 1 - z^2, so z^2 is uniform and z is not; neither knows of the angle
    CHECK(uniformity(z_squared) > alpha);
    CHECK(uniformity(angle) > alpha);
    CHECK(uniformity(z) < 1e-6);
}

TEST_CASE("hemisphere: each map is undone by its inverse, and the densities are as they say") {
    using V2 = Vector2<double>;
    Rng rng{10, 0, 0, 0};
    for (int i = 0; i < 1000; ++i) {
        const double x = rng.uniform<double>(), y = rng.uniform<double>();
        const auto uniform = sample_uniform_hemisphere(V2{x, y}), cosine = sample_cosine_hemisphere(V2{x, y});
        CHECK(std::abs(length(uniform) - 1) <= 1e-15);
        CHECK(length(invert_uniform_hemisphere(uniform) - V2{x, y}) <= 1e-14);
        CHECK(length(invert_cosine_hemisphere(cosine) - V2{x, y}) <= 1e-14);
        CHECK(std::abs(pdf_uniform_hemisphere(uniform).value * 2 * std::numbers::pi - 1) <= 1e-15);
        CHECK(std::abs(pdf_cosine_hemisphere(cosine).value * std::numbers::pi - cosine.z) <= 1e-15);
    }
    CHECK(pdf_uniform_hemisphere(Vec3{0, 0, -1}).value == 0);
    CHECK(pdf_cosine_hemisphere(Vec3{0, 0, -1}).value == 0);
    CHECK(turn(Vec3{1, -1e-30F, 0}) < 1);
}
