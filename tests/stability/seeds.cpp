/// @file seeds.cpp
/// Pixels whose random numbers are not independent: rows S50 and S51.

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "../../chapters/09_monte_carlo/seeds.hpp"
#include "math/extremes.hpp"
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
}

TEST_CASE("S51: with the same seed there is no noise where the lamp is seen whole, and hashed there is") {
    // The left column of the picture has no shadow. There a small lamp's light changes as 4 / (6.8 + y^2)^2: from one
    // pixel to the next, 0.05 away, it is off the mean of its neighbours by 3.5 * 0.05^2 / 2 * 16 / 6.8^3 = 0.0002 at
    // most, too little for a screen.
    const auto roughness = [](Seeding seeding) {
        const auto film  = floor_seeded(seeding, 32, 4, 2);
        double     worst = 0;
        for (int y = 1; y < 31; ++y) {
            const double of_neighbours = (double(film(0, y - 1).g) + double(film(0, y + 1).g)) / 2;
            worst                      = max_or_nan(worst, std::abs(double(film(0, y).g) - of_neighbours));
        }
        return worst;
    };
    constexpr double half_a_grey_level = 0.5 / 255;
    CHECK(roughness(Seeding::all_alike) <= half_a_grey_level);
    CHECK(roughness(Seeding::hashed) > half_a_grey_level);
}
