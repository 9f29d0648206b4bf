/// @file choice.cpp
/// One of several, by their shares: which one a number chooses, and what is left of the number.

#include <doctest/doctest.h>

#include <cmath>
#include <cstdint>
#include <functional>
#include <vector>

#include "material/fresnel.hpp"
#include "sampling/choice.hpp"
#include "transport/single_directions.hpp"

using namespace sr;

TEST_CASE("choice: each is drawn by its share, and the number is uniform again") {
    const std::vector<double>               weights{0, 0.5, 1, 0, 2.5, 0};
    constexpr int                           cells = 16, n = 4 * 4000;
    std::vector<std::vector<std::uint64_t>> left(weights.size(), std::vector<std::uint64_t>(cells));
    for (int i = 0; i < n; ++i) {
        const auto one = choose(weights, std::identity{}, (i + 0.5) / n);
        REQUIRE(one);
        CHECK(std::abs(one->chance - weights[one->index] / 4) <= 1e-15);
        ++left[one->index].at(std::size_t(one->u * cells));
    }
    for (std::size_t index = 0; index < weights.size(); ++index) {
        for (const auto count : left[index])
            CHECK(std::abs(double(count) - n * weights[index] / 4 / cells) <= 1);
    }
}

TEST_CASE(
    "choice: the last that can be drawn takes what rounding leaves, and none is drawn where none can be") {
    const std::vector<float> tenths(10, 0.1F);  // their shares' sum is not 1 in float
    const std::vector<float> and_nothing{0.7F, 0.2F, 0.1F, 0};
    const float              largest = 1 - 0x1p-24F;
    for (const auto& weights : {tenths, and_nothing}) {
        const auto one = choose(weights, std::identity{}, largest);
        REQUIRE(one);
        CHECK(one->index == (weights.size() == 10 ? 9 : 2));
        CHECK(one->u >= 0.99F);
        CHECK(one->u < 1);
    }
    CHECK(!choose(std::vector<float>{0, 0}, std::identity{}, 0.5F));
    CHECK(!choose(std::vector<float>{}, std::identity{}, 0.5F));
}

TEST_CASE("single directions: of mirror and glass, one way in three is drawn by its share of the light") {
    // red is seen in the mirror, green and blue in the glass: means of 0.3 and 0.6
    const Dielectric<double> glass{4.0};
    const LobeSum<double>    sum{{{{0.9F, 0, 0}, Mirror<double>{}}, {{0, 0.9F, 0.9F}, glass}}};
    const Vector3<double>    wo{0.6, 0, 0.8};
    const double             R        = fresnel(0.8, 4.0).mean();
    constexpr int            n        = 30'000;
    int                      mirrored = 0, reflected = 0, refracted = 0;
    Spectrum                 total;
    for (int i = 0; i < n; ++i) {
        draw_single_direction(sum, wo, {(i + 0.5) / n, 0.5}, [&](const Vector3<double>& wi, Spectrum weight) {
            ++(weight.r > 0 ? mirrored : wi.z > 0 ? reflected : refracted);
            total = total + weight / n;
        });
    }
    CHECK(std::abs(mirrored - n / 3.0) <= 1);
    CHECK(std::abs(reflected - n * 2 / 3.0 * R) <= 2);
    CHECK(std::abs(refracted - n * 2 / 3.0 * (1 - R)) <= 2);
    // and what is followed counts as much more as it is drawn less often
    CHECK(std::abs(total.r - 0.9F) <= 1e-3F);
    CHECK(std::abs(total.g - 0.9F * float(R + (1 - R) / 16)) <= 1e-3F);
}
