/// @file path_tracer.cpp
/// Paths where the light is known (oracles H16, H17, I1, I2, I9): every strategy, to every depth.

#include "transport/path_tracer.hpp"

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <map>
#include <regex>
#include <string>
#include <string_view>

#include "refusal.hpp"
#include "sampling/halton_point.hpp"
#include "sampling/random_point.hpp"
#include "sampling/sobol_point.hpp"
#include "sampling/stratified_point.hpp"
#include "scene/small_scenes.hpp"
#include "statistics/running.hpp"
#include "statistics/tests.hpp"

using namespace sr;
using sr::test::refusal_of;

namespace {

constexpr double     alpha = 1e-5;  // significance of each test here; seeds are fixed
constexpr std::array all_strategies{Strategy::blind, Strategy::bsdf, Strategy::light, Strategy::balance,
                                    Strategy::power};

const Ray<float> askew{{0.1F, 0.2F, -0.3F}, {0.4F, 1, 0.3F}};

/// The green radiance along a ray, over so many paths.
template <SamplePoint P = RandomPoint>
Running radiances(const Scene& scene, const PathOptions& options, const Ray<float>& ray,
                  std::uint32_t paths) {
    const PathTracer tracer(scene, options);
    PathCount        count;
    Running          L;
    for (std::uint32_t i = 0; i < paths; ++i) {
        P point(SampleId{.index = i, .count = paths});
        L.add(double(tracer.radiance(ray, point, count).g));
    }
    return L;
}

/// The p-value of a mean; of a strategy without variance, rounding is one standard error.
double p_of(const Running& L, double expected) {
    return z_test(L.mean(), std::max(L.standard_error(), 1e-6 * expected), expected).p;
}

/// Materials of which each emits 1 - rho: in a closed scene of them, the radiance is 1 everywhere.
Scene uniform_room() {
    Scene scene;
    for (const float rho : {0.0F, 0.2F, 0.4F, 0.6F, 0.8F, 0.9F})
        scene.materials.push_back(grey(rho, 1 - rho));
    add_cube(scene, -1, 1);
    return scene;
}

}  // namespace

TEST_CASE("I1: inside a ball that shines, paths of up to k bounces see (1 - rho^(k+1)) / (1 - rho)") {
    for (const float rho : {0.5F, 0.9F})
        for (const auto strategy : all_strategies)
            for (const int k : {0, 1, 3, 10, 1000}) {
                CAPTURE(int(strategy));
                CAPTURE(k);
                const auto L =
                    radiances(inside_of_a_ball(rho, 1), {.strategy = strategy, .bounces = k}, askew, 10'000);
                const double r        = double(rho);
                const double expected = (1 - std::pow(r, k + 1)) / (1 - r);
                CHECK(p_of(L, expected) > alpha);
                if (k == 3 && strategy != Strategy::blind) CHECK(p_of(L, 1.02 * expected) < alpha);
            }
}

TEST_CASE(
    "I2: where each surface emits what it absorbs, the radiance is 1, with balls of glass and of mirror in "
    "it") {
    Scene scene = uniform_room();
    scene.materials.push_back({"glass", LobeSum<float>{{{{1, 1, 1}, Dielectric<float>{1.5F}}}}, {}});
    scene.materials.push_back(
        {"mirror", LobeSum<float>{{{{0.7F, 0.7F, 0.7F}, Mirror<float>{}}}}, {0.3F, 0.3F, 0.3F}});
    scene.balls = {{Sphere<double>{{0.3, 0.6, 0}, 0.25}, 6}, {Sphere<double>{{-0.5, -0.2, 0.1}, 0.4}, 7}};
    for (const auto strategy : all_strategies) {
        CAPTURE(int(strategy));
        const auto L = radiances(scene, {.strategy = strategy}, askew, 40'000);
        CHECK(p_of(L, 1) > alpha);
        CHECK(p_of(L, 1.05) < alpha);
    }
}

TEST_CASE("I9: a ball that is a mirror within and shines: 5 in every direction") {
    Scene scene                   = inside_of_a_ball(0, 1);
    scene.materials[0].scattering = LobeSum<float>{{{{0.8F, 0.8F, 0.8F}, Mirror<float>{}}}};
    CHECK(p_of(radiances(scene, {.roulette = 0}, askew, 40'000), 5) > alpha);
    const auto all = radiances(scene, {.bounces = 100, .roulette = 100}, askew, 2);
    CHECK(all.mean() == doctest::Approx(5).epsilon(1e-5));
    CHECK(all.variance() == 0);
}

TEST_CASE("H16: roulette's variance in a furnace, rho / (1 - rho)^2 where paths go on with the chance rho") {
    for (const auto& [rho, variance] : {std::pair{0.5F, 2.0}, {0.9F, 90.0}}) {
        constexpr std::uint32_t paths = 200'000;
        const auto              L =
            radiances(inside_of_a_ball(rho, 1), {.strategy = Strategy::bsdf, .roulette = 0}, askew, paths);
        CHECK(p_of(L, 1 / (1 - double(rho))) > alpha);
        // a path's sum is the number of its surfaces, a geometric variable, whose fourth moment says how far off it
        // may be
        const double r = double(rho), kurtosis = 9 + (1 - r) * (1 - r) / r;
        const double error = variance * std::sqrt((kurtosis - 1) / paths);
        CHECK(z_test(L.variance(), error, variance).p > alpha);
        CHECK(z_test(L.variance(), error, 1.1 * variance).p < alpha);
    }
}

TEST_CASE(
    "a lamp that shines from its front is black from behind, and lights no other side, by any strategy") {
    Scene scene;
    scene.materials                  = {grey(0.5F), grey(0, 1)};
    scene.materials[1].shines_behind = false;
    add_quad(scene, {{{-9, -9, 0}, {9, -9, 0}, {9, 9, 0}, {-9, 9, 0}}}, 0);
    add_quad(scene, {{{-1, -1, 1}, {1, -1, 1}, {1, 1, 1}, {-1, 1, 1}}}, 1);  // its front is up
    add_quad(scene, {{{-9, -9, 4}, {9, -9, 4}, {9, 9, 4}, {-9, 9, 4}}}, 0);
    const Ray<float> to_lamp{{0, 0, 0.5F}, {0, 0, 1}}, to_front{{0, 0, 2}, {0, 0, -1}};
    const Ray<float> to_floor{{0, 0, 0.5F}, {0, 0, -1}}, to_ceiling{{0, 0, 2}, {0, 0, 1}};
    for (const auto strategy : all_strategies) {
        const auto L = [&](const Ray<float>& ray) {
            return radiances(scene, {.strategy = strategy, .bounces = 1}, ray, 1000).mean();
        };
        CHECK(L(to_lamp) == 0);
        CHECK(L(to_front) == 1);
        CHECK(L(to_floor) == 0);
        CHECK(L(to_ceiling) > 0);
    }
}

TEST_CASE("what shines and is flat does not light itself, however triangles are drawn from") {
    // Drawn from by solid angle, it did from 47 of these points, whose rounding moves them off its plane.
    Scene scene;
    scene.materials = {grey(0.5F, 1)};
    add_quad(scene, {{{-1, -1, 1}, {1, -1, 1}, {1, 1, 1}, {-1, 1, 1}}}, 0);
    for (const auto triangles :
         {TriangleSampling::area, TriangleSampling::solid_angle, TriangleSampling::by_distance}) {
        const PathTracer tracer(scene, {.strategy = Strategy::light, .triangles = triangles});
        PathCount        count;
        int              right = 0;
        for (std::uint32_t i = 0; i < 200'000; ++i) {
            RandomPoint         point(SampleId{.index = i});
            const std::uint32_t column = i % 1000, row = i / 1000;
            const Ray<float>    up{{1.8F * float(column) / 1000 - 0.9F, 1.8F * float(row) / 200 - 0.9F, 0},
                                {0, 0, 1}};
            right += tracer.radiance(up, point, count) == Spectrum{1, 1, 1};
        }
        CHECK(right == 200'000);
    }
}

TEST_CASE("a path's light, way by way: its sum is the radiance, and each way is one that there is") {
    Scene scene = uniform_room();
    scene.materials.push_back({"glass", LobeSum<float>{{{{1, 1, 1}, Dielectric<float>{1.5F}}}}, {}});
    scene.balls = {{Sphere<double>{{0.3, 0.6, 0}, 0.25}, 6}};
    for (const auto strategy : all_strategies) {
        const PathTracer               tracer(scene, {.strategy = strategy, .bounces = 4});
        std::map<std::string, Running> ways;
        PathCount                      count;
        for (std::uint32_t i = 0; i < 2000; ++i) {
            HaltonPoint    point(SampleId{.index = i, .count = 2000}), again = point;
            DoubleSpectrum sum;
            tracer.each_light(askew, point, count, [&](std::string_view way, Spectrum L) {
                sum = sum + convert<double>(L);
                ways[std::string(way)].add(double(L.g));
            });
            CHECK(sum.g == doctest::Approx(double(tracer.radiance(askew, again, count).g)).epsilon(1e-5));
        }
        for (const auto& [way, L] : ways) {
            CAPTURE(way);
            CHECK(std::regex_match(way, std::regex("L[DS]{0,4}E")));
            CHECK(L.mean() > 0);
        }
        CHECK(ways.contains("LSSE"));
        CHECK(ways.contains("LDSSE"));
        CHECK_FALSE(ways.contains("LDE"));  // the ball of glass is what the eye meets first
    }
}

TEST_CASE("patterns of samples change the noise and not the mean") {
    const Scene scene   = uniform_room();
    const auto  at_wall = [&]<class P>(P*) {
        return radiances<P>(scene, {.roulette = 8}, askew, 16'384).mean();
    };
    const double error = radiances(scene, {.roulette = 8}, askew, 16'384).standard_error();
    CHECK(z_test(at_wall((RandomPoint*)nullptr), error, 1).p > alpha);
    CHECK(z_test(at_wall((StratifiedPoint*)nullptr), error, 1).p > alpha);
    CHECK(z_test(at_wall((HaltonPoint*)nullptr), error, 1).p > alpha);
    CHECK(std::abs(at_wall((SobolPoint*)nullptr) - 1) < error);
}

TEST_CASE(
    "what is passed over counts: no light that can't be met by chance, and no lamp behind a mirror twice") {
    Scene scene;
    scene.materials = {
        grey(0.5F), {"mirror", LobeSum<float>{{{{1, 1, 1}, Mirror<float>{}}}}, {}}, grey(0, 1)};
    add_quad(scene, {{{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}}}, 1);
    scene.balls = {{Sphere<double>{{0, 0, 3}, 1}, 2}};
    const Ray<float> to_mirror{{0, 0, 1}, {0, 0, -1}};
    for (const auto strategy : all_strategies)
        CHECK(radiances(scene, {.strategy = strategy}, to_mirror, 4).mean() ==
              doctest::Approx(1).epsilon(1e-6));
}

TEST_CASE("paths: options that make no sense are refused") {
    const Scene scene   = inside_of_a_ball(0.5F, 1);
    const auto  refusal = [&](const PathOptions& options) {
        return refusal_of([&] { PathTracer{scene, options}; });
    };
    CHECK(refusal({}) == "accepted");
    CHECK(refusal({.bounces = -1}) == "-1 bounces: must be 0 to 100000");
    CHECK(refusal({.bounces = 100'001}) == "100001 bounces: must be 0 to 100000");
    CHECK(refusal({.roulette = -1}) == "roulette from bounce -1: must be 0 or more");
}
