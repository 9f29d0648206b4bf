/// @file sampled_image.cpp
/// Pictures that know how good they are, and what their pixels see.

#include "transport/sampled_image.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <string>

#include "sampling/random_point.hpp"
#include "sampling/sobol_point.hpp"
#include "scene/cornell_box.hpp"
#include "statistics/tests.hpp"
#include "transport/path_tracer.hpp"

using namespace sr;

namespace {

constexpr double alpha = 1e-5;  // significance of each test here; seeds are fixed

Camera<float> camera(int side) {
    return convert<float>(cornell_box_camera(side));
}

/// Of variance 1/12 a sample, and of mean 1/2.
constexpr auto noise = [](const Ray<float>&, auto& point) {
    const float x = point.template number<float>();
    return Spectrum{x, x, x};
};

}  // namespace

TEST_CASE("sampled images: the standard error that they state is that of their means") {
    SampledImage image(camera(40), {.seed = 1, .samples = 4});
    for (int pass = 0; pass < 16; ++pass) image.add_pass<RandomPoint>({}, noise);
    CHECK(image.samples() == 40 * 40 * 64);
    const auto mean = image.mean();
    const auto se   = image.standard_errors();
    Running    errors, squares;
    for (int y = 0; y < 40; ++y)
        for (int x = 0; x < 40; ++x) {
            const double error = double(mean(x, y).g) - 0.5;
            errors.add(error * error);
            squares.add(double(se(x, y)) * double(se(x, y)));
        }
    const double expected = 1.0 / 12 / 64;
    CHECK(z_test(errors.mean(), errors.standard_error(), expected).p > alpha);
    CHECK(z_test(squares.mean(), squares.standard_error(), expected).p > alpha);
    CHECK(z_test(errors.mean(), errors.standard_error(), 1.3 * expected).p < alpha);
    CHECK(image.relative_error() == doctest::Approx(std::sqrt(expected) / 0.5).epsilon(0.03));

    SampledImage better(camera(40), {.seed = 1, .samples = 64});  // whose samples know of each other
    for (int pass = 0; pass < 2; ++pass) better.add_pass<SobolPoint>({}, noise);
    CHECK(better.relative_error() < image.relative_error() / 20);
}

TEST_CASE("sampled images: an error is not known before the second pass") {
    SampledImage image(camera(4), {});
    CHECK(std::isinf(image.relative_error()));
    image.add_pass<RandomPoint>({}, noise);
    CHECK(std::isinf(image.relative_error()));
    CHECK(std::isnan(image.standard_errors()(0, 0)));
    image.add_pass<RandomPoint>({}, noise);
    CHECK(std::isfinite(image.relative_error()));
}

TEST_CASE("sampled images: the error may be that of some pixels only, and of none there is none") {
    SampledImage image(camera(8), {.samples = 1});
    for (int pass = 0; pass < 2; ++pass)
        image.add_pass<RandomPoint>({}, [](const Ray<float>& ray, RandomPoint& point) {
            const float x = ray.direction.x > 0 ? 1 : 2 * point.number<float>();
            return Spectrum{x, x, x};
        });
    PixelMask left(8, 8, 0), right(8, 8, 0);
    for (int y = 0; y < 8; ++y)
        for (int x = 0; x < 4; ++x) left(x, y) = right(x + 4, y) = 1;
    CHECK(std::min(image.relative_error(left), image.relative_error(right)) == 0);
    CHECK(std::max(image.relative_error(left), image.relative_error(right)) > image.relative_error());
    CHECK(image.relative_error() > 0);
    CHECK(std::isnan(image.relative_error(PixelMask(8, 8, 0))));
    CHECK(image.passes(0, 0) == 2);
}

TEST_CASE("sampled images: pixels that are wanted get samples, and threads change nothing") {
    const PathTracer tracer(cornell_box(), {});
    const auto       radiance = [&](const Ray<float>& ray, auto& point) {
        PathCount count;
        return tracer.radiance(ray, point, count);
    };
    const auto film = [&](int threads) {
        SampledImage image(camera(33), {.samples = 4});
        image.add_pass<SobolPoint>({threads}, radiance);
        image.add_pass<SobolPoint>({threads}, radiance, [](int x, int y) { return x < y; });
        CHECK(image.samples() == 4 * (33 * 33 + 33 * 32 / 2));
        return image.mean();
    };
    const auto one = film(1);
    CHECK(film(2) == one);
    CHECK(film(7) == one);
}

TEST_CASE("sampled images: a bad sample is told with its pixel and its number") {
    SampledImage image(camera(8), {.samples = 4});
    const auto   bad = [](const Ray<float>&, auto& point) {
        const float x = point.template number<float>();
        return Spectrum{x < 0.004F ? std::nanf("") : x, x, x};
    };
    std::string told = "nothing";
    try {
        for (int pass = 0; pass < 4; ++pass) image.add_pass<RandomPoint>({}, bad);
    } catch (const BadSample& error) {
        told = error.what();
    }
    int x = -1, y = -1, sample = -1;
    REQUIRE(std::sscanf(told.c_str(), "sample %d of pixel (%d, %d)", &sample, &x, &y) == 3);
    RandomPoint again(SampleId{hash(1, sample / 4), x, y, std::uint32_t(sample % 4), 4});
    static_cast<void>(again.pair<float>());  // where in the pixel
    CHECK(again.number<float>() < 0.004F);
}

TEST_CASE("pixel filters: samples lie about the middle with the filter's variance") {
    struct Known {
        PixelFilter filter;
        double      variance, reach;
    };
    for (const auto& [filter, variance, reach] :
         {Known{PixelFilter::box, 1.0 / 12, 0.5},
          {PixelFilter::tent, 1.0 / 6, 1.0},
          {PixelFilter::gaussian, 0.2493288, 2.0}}) {  // 1/4 less e^-8 of the tail
        Running x, x2, xy;
        for (std::uint32_t i = 0; i < 100'000; ++i) {
            RandomPoint  point(SampleId{.index = i});
            const Vec2   at = sample_filter(filter, point.pair<float>());
            const double dx = double(at.x) - 0.5, dy = double(at.y) - 0.5;
            CHECK(std::hypot(dx, dy) <= std::sqrt(2) * reach);
            x.add(dx), x2.add(dy * dy), xy.add(dx * dy);
        }
        CHECK(z_test(x.mean(), x.standard_error(), 0).p > alpha);
        CHECK(z_test(x2.mean(), x2.standard_error(), variance).p > alpha);
        CHECK(z_test(xy.mean(), xy.standard_error(), 0).p > alpha);
        CHECK(z_test(x2.mean(), x2.standard_error(), 1.05 * variance).p < alpha);
    }
}
