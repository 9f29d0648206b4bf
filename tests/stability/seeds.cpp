/// @file seeds.cpp
/// Pixels whose random numbers are not independent: rows S50 and S51.

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "../../chapters/09_monte_carlo/seeds.hpp"
#include "near.hpp"

using namespace sr;
using test::near;

TEST_CASE("S50: a simple generator that is seeded with the pixel's number is the same in all neighbours") {
    constexpr int       pixels = 10'000;
    std::vector<double> by_index, hashed;
    for (int i = 0; i < pixels; ++i) {
        by_index.push_back(IndexSeeded(i).uniform());
        hashed.push_back(Rng(1, i, 0, 0).uniform<double>());
    }
    CHECK(correlation_of_neighbours(by_index) == near(1, 1e-6));
    CHECK(std::abs(*std::ranges::min_element(by_index) - 0.0966) <= 5e-5);
    CHECK(std::abs(*std::ranges::max_element(by_index) - 0.1749) <= 5e-5);
    CHECK(std::abs(correlation_of_neighbours(hashed)) <= 5 / std::sqrt(double(pixels)));
    CHECK(*std::ranges::min_element(hashed) < 0.01);
    CHECK(*std::ranges::max_element(hashed) > 0.99);
}

TEST_CASE("S51: with the same seed every pixel errs alike, and no number of pixels helps") {
    constexpr int pixels = 10'000;
    const auto    image  = [](bool alike, std::uint64_t seed) {
        Running of;  // the pixels' means of 16 numbers
        for (int i = 0; i < pixels; ++i) {
            Rng    rng{seed, alike ? 0 : i, 0, 0};
            double sum = 0;
            for (int k = 0; k < 16; ++k) sum += rng.uniform<double>();
            of.add(sum / 16);
        }
        return of;
    };
    const double of_pixel = 1 / std::sqrt(12.0 * 16), of_image = of_pixel / 100;
    CHECK(of_image == near(0.00072, 0.01));
    Running squares;
    for (std::uint64_t seed = 1; seed <= 64; ++seed) {
        const auto alike = image(true, seed);
        CHECK(alike.variance() == 0);
        squares.add((alike.mean() - 0.5) * (alike.mean() - 0.5));
    }
    // the image is as wrong as a pixel: 5 sqrt(2 / 64) of the variance
    CHECK(std::abs(squares.mean() / (of_pixel * of_pixel) - 1) <= 5 * std::sqrt(2.0 / 64));
    const auto hashed = image(false, 1);
    CHECK(std::abs(hashed.mean() - 0.5) <= 5 * of_image);
    CHECK(std::sqrt(hashed.variance()) == near(of_pixel, 0.05));
    // and so it is on the floor of 9.10, where the same seed leaves no noise on what is lit evenly
    const auto one   = floor_seeded(Seeding::all_alike, 32, 4, 1),
               other = floor_seeded(Seeding::all_alike, 32, 4, 7);
    CHECK(one == other);
}
