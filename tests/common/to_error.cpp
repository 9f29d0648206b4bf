/// @file to_error.cpp
/// Pictures that are rendered to a requested error.

#include "transport/to_error.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <cstdint>
#include <stdexcept>

#include "math/square.hpp"
#include "sampling/random_point.hpp"
#include "sampling/sobol_point.hpp"
#include "scene/cornell_box.hpp"
#include "statistics/tests.hpp"
#include "transport/path_tracer.hpp"
#include "transport/traced.hpp"

using namespace sr;

namespace {

constexpr double alpha = 1e-5;  // significance of each test here; seeds are fixed

Camera<float> camera(int side) {
    return convert<float>(cornell_box_camera(side));
}

constexpr auto always = [](const SampledImage&) { return true; };

bool on_the_right(const Ray<float>& ray) {
    return dot(ray.direction, camera(2).right) > 0;
}

/// Noise of standard deviation 1 about 10 on the left, and of 3 on the right.
constexpr auto two_halves = [](const Ray<float>& ray, RandomPoint& point) {
    const float deviation = on_the_right(ray) ? 3 : 1;
    const float L         = 10 + deviation * std::sqrt(12.0F) * (point.number<float>() - 0.5F);
    return Spectrum{L, L, L};
};

/// 1 on average: mostly nothing, and rarely much.
constexpr auto hit_or_miss = [](const Ray<float>&, RandomPoint& point) {
    const float L = point.number<float>() < 0.125F ? 8 : 0;
    return Spectrum{L, L, L};
};

Running brightness_of(const Image<Spectrum>& film) {
    Running all;
    for (const auto& L : film.pixels()) all.add(double(mean(L)));
    return all;
}

}  // namespace

TEST_CASE("to an error: passes are shared out by the deviations that the pilot saw, and partly evenly") {
    SampledImage pilot(camera(32), {.samples = 1});
    for (int pass = 0; pass < 64; ++pass) pilot.add_pass<RandomPoint>({}, two_halves);
    PixelMask mask(32, 32, 1);
    for (int x = 0; x < 32; ++x) mask(x, 0) = 0;
    const auto shares = pass_shares(pilot, mask, 0.25);
    Running    left, right;
    for (int y = 1; y < 32; ++y)
        for (int x = 0; x < 32; ++x)
            if (x < 14)
                left.add(shares(x, y));
            else if (x >= 18)
                right.add(shares(x, y));
    CHECK(left.mean() == doctest::Approx(0.25 + 0.75 * 1 / 2).epsilon(0.03));
    CHECK(right.mean() == doctest::Approx(0.25 + 0.75 * 3 / 2).epsilon(0.03));
    CHECK(shares(5, 0) == 1);

    SampledImage even(camera(4), {.samples = 1});  // no noise anywhere
    for (int pass = 0; pass < 2; ++pass)
        even.add_pass<RandomPoint>({}, [](const Ray<float>&, RandomPoint&) { return Spectrum{1, 1, 1}; });
    CHECK(pass_shares(even, PixelMask(4, 4, 1), 0.25) == Image<double>(4, 4, 1));
}

TEST_CASE("to an error: the error that is reached is the one that was asked for, of the Cornell box") {
    constexpr int    side  = 16;
    const Scene      scene = cornell_box();
    const auto       view  = cornell_box_camera(side);
    const auto       mask  = without_emitters(scene, view);
    const PathTracer tracer(scene);
    const auto       radiance = [&](const Ray<float>& ray, SobolPoint& point) {
        PathCount count;
        return tracer.radiance(ray, point, count);
    };
    const auto reference = traced(scene, view, {}, {.seed = 77, .samples = 2048}, {}, 4);
    const auto truth     = reference.mean();
    Running    radiances;
    for (std::size_t i = 0; i < mask.pixels().size(); ++i)
        if (mask.pixels()[i] != 0) radiances.add(double(mean(truth.pixels()[i])));
    Running squares;  // of the errors that are reached, over those asked for
    for (const double asked : {0.1, 0.05, 0.025})
        for (std::uint64_t seed = 1; seed <= 3; ++seed) {
            const auto image =
                traced_to_error<SobolPoint>(convert<float>(view), mask, {.error = asked},
                                            {.seed = seed, .samples = 4}, {}, radiance, always);
            CHECK(image.relative_error(mask) <= asked);
            CHECK(image.relative_error(mask) > 0.9 * asked);  // and no more work than that takes
            const auto   film         = image.mean();
            const double of_reference = square(reference.relative_error(mask));
            for (std::size_t i = 0; i < mask.pixels().size(); ++i)
                if (mask.pixels()[i] != 0)
                    squares.add(
                        (square(double(mean(film.pixels()[i]) - mean(truth.pixels()[i])) / radiances.mean()) -
                         of_reference) /
                        square(asked));
        }
    CHECK(z_test(squares.mean(), squares.standard_error(), 0.95).p > alpha);  // 0.9 to 1
    CHECK(z_test(squares.mean(), squares.standard_error(), square(1.25)).p < alpha);
    CHECK(z_test(squares.mean(), squares.standard_error(), square(0.75)).p < alpha);
}

TEST_CASE("to an error: no pixel's samples decide about itself, and so none of the light is lost") {
    PixelMask  mask(48, 48, 1);
    const auto image = traced_to_error<RandomPoint>(camera(48), mask, {.error = 0.3}, {.samples = 2}, {},
                                                    hit_or_miss, always);
    const auto all   = brightness_of(image.mean());
    CHECK(z_test(all.mean(), all.standard_error(), 1).p > alpha);

    // the same test refuses pixels that stop as soon as they seem to be right
    SampledImage greedy(camera(48), {.samples = 2});
    for (int pass = 0; pass < 2; ++pass) greedy.add_pass<RandomPoint>({}, hit_or_miss);
    for (int pass = 0; pass < 100; ++pass) {
        const auto errors = greedy.standard_errors();
        greedy.add_pass<RandomPoint>({}, hit_or_miss, [&](int x, int y) { return errors(x, y) > 0.3F; });
    }
    const auto lost = brightness_of(greedy.mean());
    CHECK(z_test(lost.mean(), lost.standard_error(), 1).p < alpha);
}

TEST_CASE("to an error: what is interrupted is whole, with as many passes as it says") {
    const auto after = [](int passes) {
        return traced_to_error<RandomPoint>(camera(8), PixelMask(8, 8, 1), {.error = 0.01, .pilot = 3},
                                            {.samples = 2}, {}, hit_or_miss,
                                            [&](const SampledImage&) { return --passes > 0; });
    };
    CHECK(after(1).samples() == 1 * 2 * 64);  // of the pilot
    CHECK(after(3).samples() == 3 * 2 * 64);
    CHECK(after(4).samples() == 3 * 2 * 64);  // one pass of the picture says nothing of its error
    CHECK(after(5).samples() == 2 * 2 * 64);  // two do
    CHECK(std::isfinite(after(5).relative_error()));
    CHECK(after(3).mean() == after(4).mean());
    CHECK(after(3).mean() != after(5).mean());
}

TEST_CASE("to an error: a picture that is black at first goes on") {
    REQUIRE(next_passes(2, std::nan(""), 0.2) == 3);  // or there would be no end
    int        samples = 0;
    const auto late    = [&](const Ray<float>&, RandomPoint& point) {
        const bool  dark = samples >= 4 * 16 && samples < 7 * 16;  // the picture's first three passes
        const float L    = dark ? 0 : 1 + point.number<float>();
        ++samples;
        return Spectrum{L, L, L};
    };
    int        passes = 0;
    const auto image =
        traced_to_error<RandomPoint>(camera(4), PixelMask(4, 4, 1), {.error = 0.2}, {.samples = 1}, {}, late,
                                     [&](const SampledImage&) { return ++passes < 1000; });
    CHECK(passes < 1000);
    CHECK(image.relative_error() <= 0.2);
}

TEST_CASE("to an error: threads change nothing, and where no light arrives there is no error to reach") {
    const auto run = [](int threads, const auto& radiance) {
        return traced_to_error<RandomPoint>(camera(33), PixelMask(33, 33, 1), {.error = 0.2}, {.samples = 2},
                                            {threads}, radiance, always);
    };
    const auto one = run(1, hit_or_miss);
    CHECK(run(7, hit_or_miss).mean() == one.mean());
    CHECK(run(2, hit_or_miss).samples() == one.samples());
    CHECK_THROWS_AS(static_cast<void>(run(1, [](const Ray<float>&, RandomPoint&) { return Spectrum{}; })),
                    std::runtime_error);
    CHECK_THROWS_AS(static_cast<void>(traced_to_error<RandomPoint>(camera(4), PixelMask(4, 4, 0), {}, {}, {},
                                                                   hit_or_miss, always)),
                    std::runtime_error);
}
