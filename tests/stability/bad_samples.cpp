/// @file bad_samples.cpp
/// Samples that are no radiance: row S48.

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

#include "transport/render.hpp"

using namespace sr;

namespace {

/// A camera of 8 x 8 pixels whose pixel (5, 3) has one bad sample out of four.
Image<Spectrum> with_one(Spectrum bad) {
    const auto camera = pinhole_camera<float>({0, 0, 0}, {0, 0, 1}, {0, 1, 0}, 1, 1, 8, 8);
    const auto target = camera.ray({5.25F, 3.75F}).direction;  // sample 2 of the pixel
    return render(camera, {.samples = 4}, {}, [&](const Ray<float>& ray, Rng&) {
        return ray.direction == target ? bad : Spectrum{1, 1, 1};
    });
}

}  // namespace

TEST_CASE("S48: a bad sample hides in a maximum, a power and a blur; a render names it and its pixel") {
    constexpr float NaN = std::numeric_limits<float>::quiet_NaN();
    CHECK(std::isnan(std::max(NaN, 0.0F)));
    CHECK(std::max(0.0F, NaN) == 0);  // gone
    CHECK(std::isnan(std::pow(-1e-3F, 1 / 2.2F)));
    std::array<float, 11> row{};
    row[4] = NaN;
    CHECK(std::isnan(std::accumulate(row.begin(), row.end(), 0.0F) / 11));

    CHECK_THROWS_WITH_AS((void)with_one({NaN, 0, 0}),
                         "sample 2 of pixel (5, 3) is (nan, 0, 0); must be finite and not negative",
                         BadSample);
    CHECK_THROWS_WITH_AS((void)with_one({0, -1, 0}),
                         "sample 2 of pixel (5, 3) is (0, -1, 0); must be finite and not negative",
                         BadSample);
    CHECK_THROWS_AS((void)with_one({0, 0, HUGE_VALF}), BadSample);
    const auto good = with_one({5, 5, 5});
    CHECK(good(5, 3) == Spectrum{2, 2, 2});
    CHECK(good(4, 3) == Spectrum{1, 1, 1});
}
