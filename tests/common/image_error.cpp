/// @file image_error.cpp
/// How wrong a picture is, and which of its pixels count.

#include "transport/image_error.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "math/square.hpp"
#include "scene/cornell_box.hpp"
#include "scene/small_scenes.hpp"
#include "statistics/running.hpp"
#include "statistics/tests.hpp"
#include "transport/traced.hpp"

using namespace sr;

TEST_CASE("relative RMSE: over channels and the pixels that count, and NaN is not lost") {
    Image<Spectrum> R(2, 1, {1, 2, 3}), I(2, 1, {1, 2, 3});
    PixelMask       both(2, 1, 1), first = both;
    first(1, 0) = 0;
    CHECK(relative_rmse(I, R, both) == 0);
    I(0, 0) = {2, 2, 3};  // one of six channels is wrong by 1, and the mean is 2
    CHECK(relative_rmse(I, R, both) == doctest::Approx(std::sqrt(1.0 / 6) / 2).epsilon(1e-7));
    CHECK(relative_rmse(I, R, first) == doctest::Approx(std::sqrt(1.0 / 3) / 2).epsilon(1e-7));
    I(1, 0).g = std::numeric_limits<float>::quiet_NaN();
    CHECK(std::isnan(relative_rmse(I, R, both)));
    CHECK(std::isfinite(relative_rmse(I, R, first)));
    CHECK(std::isnan(relative_rmse(I, R, PixelMask(2, 1, 0))));
}

TEST_CASE("pixels that see the lamp do not count, and nearly all others do") {
    const Scene box  = cornell_box();
    const auto  mask = without_emitters(box, cornell_box_camera(64));
    CHECK(mask(32, 9) == 0);  // the lamp's middle
    CHECK(mask(32, 32) == 1);
    const auto left_out = std::ranges::count(mask.pixels(), 0);
    CHECK(left_out > 30);
    CHECK(left_out < 90);
    Scene lit      = box;
    lit.background = {1, 1, 1};  // seen around the box
    CHECK(std::ranges::count(without_emitters(lit, cornell_box_camera(64)).pixels(), 0) > left_out);
}

TEST_CASE("a picture's standard errors are its distance from a better one") {
    Scene room;
    for (const float rho : {0.0F, 0.2F, 0.4F, 0.6F, 0.8F, 0.9F}) room.materials.push_back(grey(rho, 1));
    add_cube(room, -1, 1);
    const Camera<double> camera =
        pinhole_camera<double>({-0.8, -0.7, -0.9}, {1, 0.8, 0.9}, {0, 1, 0}, 1, 1, 12, 12);
    const auto better  = traced(room, camera, {}, {.seed = 2, .samples = 4096}, {}).mean();
    const auto image   = traced(room, camera, {}, {.seed = 1, .samples = 16}, {}, 16);
    const auto picture = image.mean();
    const auto errors  = image.standard_errors();
    Running    squares;
    for (int y = 0; y < 12; ++y)
        for (int x = 0; x < 12; ++x)
            squares.add(square(double((mean(picture(x, y)) - mean(better(x, y))) / errors(x, y))));
    // of 16 passes, t^2 with 15 degrees of freedom: mean 15 / 13, variance 2 * 15^2 * 14 / (13^2 * 11)
    const double error = std::sqrt(2 * 225.0 * 14 / (169 * 11) / 144);
    CHECK(z_test(squares.mean(), error, 15.0 / 13).p > 1e-5);
    CHECK(z_test(3 * squares.mean(), error, 15.0 / 13).p <
          1e-5);  // errors that are too small by the root of 3
}
