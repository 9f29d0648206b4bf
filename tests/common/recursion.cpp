/// @file recursion.cpp
/// The recursive ray tracer against sums that are known.

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>
#include <set>
#include <stdexcept>
#include <utility>
#include <vector>

#include "scene/cornell_box.hpp"
#include "statistics/running.hpp"
#include "statistics/tests.hpp"
#include "transport/recursion.hpp"
#include "transport/render.hpp"

using namespace sr;

namespace {

Material mirror(float reflectance, float emission = 0) {
    const Spectrum rho{reflectance, reflectance, reflectance};
    return {"mirror", LobeSum<float>{{{rho, Mirror<float>{}}}}, {emission, emission, emission}};
}

Material glass(float n) {
    return {"glass", LobeSum<float>{{{{1, 1, 1}, Dielectric<float>{n}}}}};
}

/// A sphere of radius 2 around the origin that shines, and whatever is in it.
Scene furnace(Material wall, std::vector<Ball> balls = {}, std::vector<Material> more = {}) {
    Scene scene;
    scene.materials = {std::move(wall)};
    scene.materials.insert(scene.materials.end(), more.begin(), more.end());
    scene.balls = std::move(balls);
    scene.balls.push_back({{{0, 0, 0}, 2}, 0});
    return scene;
}

Vec3 some_direction(Rng& rng) {
    const float z = 2 * rng.uniform() - 1, phi = 2 * std::numbers::pi_v<float> * rng.uniform();
    const float r = std::sqrt((1 - z) * (1 + z));
    return {r * std::cos(phi), r * std::sin(phi), z};
}

float L_of(const Scene& scene, const RecursionOptions& options, const Ray<float>& ray, RayCount& count,
           std::int64_t sample = 0) {
    Rng rng{1, 0, 0, sample};
    return RecursiveTracer(scene, options).radiance(ray, rng, count).g;
}

float L_of(const Scene& scene, const RecursionOptions& options, const Ray<float>& ray) {
    RayCount count;
    return L_of(scene, options, ray, count);
}

}  // namespace

TEST_CASE("I9: inside a mirror that shines, L = Le / (1 - rho) = 5 in every direction") {
    const Scene scene = furnace(mirror(0.8F, 1));
    Rng         rng{9, 0, 0, 0};
    for (int i = 0; i < 100; ++i) {
        const Vec3 from = 1.9F * rng.uniform() * some_direction(rng);
        CHECK(std::abs(L_of(scene, {.depth = 100}, {from, some_direction(rng)}) - 5) <= 1e-5F);
    }
}

TEST_CASE("D18: rays k deep see the partial sum Le (1 - rho^k) / (1 - rho), and are k") {
    const Scene scene = furnace(mirror(0.5F, 1));
    for (const auto& [k, expected] : {std::pair{1, 1.0F}, {5, 1.9375F}, {10, 1.998046875F}}) {
        for (const auto branching : {Branching::split, Branching::random}) {
            RayCount count;
            CHECK(std::abs(L_of(scene, {.depth = k, .branching = branching}, {{0.3F, 0.2F, 0.1F}, {1, 2, 3}},
                                count) -
                           expected) <= 1e-6F);
            CHECK(count.rays == std::uint64_t(k));
            CHECK(count.shadow_rays == 0);
        }
    }
}

TEST_CASE("recursion: a branch that counts no more than the cut-off ends") {
    // 0.5^j > 0.01 for j = 0 ... 6: seven rays, which see 2 (1 - 2^-7)
    RayCount    count;
    const Scene scene = furnace(mirror(0.5F, 1));
    CHECK(std::abs(L_of(scene, {.depth = 100, .cut_off = 0.01F}, {{0, 0, 0}, {0, 0, 1}}, count) -
                   2 * (1 - 0x1p-7F)) <= 1e-6F);
    CHECK(count.rays == 7);
}

TEST_CASE("recursion: a tree without end is an error; with a cut-off or a branch at random, it isn't one") {
    // two mirrors in one: each level has twice the rays
    const Spectrum half{0.5F, 0.5F, 0.5F};
    const Scene    scene =
        furnace({"mirrors", LobeSum<float>{{{half, Mirror<float>{}}, {half, Mirror<float>{}}}}, {1, 1, 1}});
    const auto seen = [&](const RecursionOptions& options) {
        return L_of(scene, options, {{0.3F, 0.2F, 0.1F}, {1, 2, 3}});
    };
    CHECK_THROWS_WITH(
        (void)seen({.depth = 64}),
        "a pixel's tree of rays, of depth 64 and cut-off 0, has more than 1000000; take a smaller "
        "depth or a larger cut-off");
    CHECK(std::abs(seen({.depth = 10}) - 10) <= 1e-4F);
    CHECK(std::abs(seen({.depth = 64, .cut_off = 0.1F}) - 4) <= 1e-5F);  // 1/8 counts, 1/16 does not
    CHECK(std::abs(seen({.depth = 64, .branching = Branching::random}) - 64) <= 1e-3F);
    // the count of a whole image may be larger
    RayCount count{.rays = 2'000'000};
    CHECK(std::abs(L_of(scene, {.depth = 10}, {{0.3F, 0.2F, 0.1F}, {1, 2, 3}}, count) - 10) <= 1e-4F);
}

TEST_CASE("furnace: where all shines alike, glass is not to be seen, from outside and from inside") {
    // 1 - R arrives by one way and R by the other, whatever R is; n^2 is scaled away on the way out
    const Scene scene =
        furnace(diffuse_material("wall", {}, {1, 1, 1}), {{{{0, 0, 0}, 1}, 1}}, {glass(1.5F)});
    Rng rng{2, 0, 0, 0};
    for (int i = 0; i < 100; ++i) {
        const Vec3 to = 0.99F * some_direction(rng), from{0, 0, 1.5F};
        CHECK(std::abs(L_of(scene, {.depth = 40}, {from, to - from}) - 1) <= 1e-4F);
    }
    // at the centre all arrives at right angles: radiance is n^2 times that outside
    CHECK(std::abs(L_of(scene, {.depth = 20}, {{0, 0, 0}, {1, 1, 1}}) - 2.25F) <= 1e-5F);
}

TEST_CASE("random branches: their mean is what the tree of all of them sees") {
    const Scene scene =
        furnace(diffuse_material("wall", {}, {1, 1, 1}), {{{{0, 0, 0}, 1}, 1}},
                {{"varnish", LobeSum<float>{{{{0.3F, 0.3F, 0.3F}, Mirror<float>{}},
                                             {{0.6F, 0.6F, 0.6F}, Dielectric<float>{1.5F}}}}}});
    const Ray<float> ray{{0, 0.6F, 1.5F}, {0, 0, -1}};
    const float      expected = L_of(scene, {.depth = 12}, ray);
    Running          drawn;
    for (int i = 0; i < 20'000; ++i) {
        RayCount count;
        drawn.add(double(L_of(scene, {.depth = 12, .branching = Branching::random}, ray, count, i)));
        CHECK(count.rays <= 12);
    }
    CHECK(z_test(drawn.mean(), drawn.standard_error(), double(expected)).p > 1e-3);
    // the control: the mirror's share of the light is missing
    CHECK(z_test(drawn.mean() - 0.3, drawn.standard_error(), double(expected)).p < 1e-6);
}

TEST_CASE("B1: a point light lights by I cos / r^2, not through what is before it, and past what is beyond") {
    // a floor of reflectance 0.5 at z = 0, seen from (3, 0, 4); the light 2 above (1, 0, 0)
    Scene scene;
    scene.materials        = {diffuse_material("floor", {0.5F, 0.5F, 0.5F}), glass(1.5F)};
    scene.mesh             = {{{-9, -9, 0}, {9, -9, 0}, {0, 9, 0}}, {{0, 1, 2}}};
    scene.material_of_face = {0};
    scene.lights           = {{{1, 0, 2}, {10, 10, 10}}};
    const auto seen        = [&](float x, RayCount& count) {
        return L_of(scene, {}, {{3, 0, 4}, Vec3{x, 0, 0} - Vec3{3, 0, 4}}, count);
    };
    RayCount     count;
    const double k = 0.5 / std::numbers::pi * 10;
    CHECK(std::abs(double(seen(1, count)) / (k / 4) - 1) <= 1e-6);
    CHECK(std::abs(double(seen(-0.5F, count)) / (k * 0.8 / 6.25) - 1) <= 1e-6);  // r = 2.5, cos = 2 / 2.5
    CHECK(count.rays == 2);
    CHECK(count.shadow_rays == 2);
    scene.balls = {{{{1, 0, 2.5}, 0.25}, 0}};  // beyond the light
    CHECK(std::abs(double(seen(1, count)) / (k / 4) - 1) <= 1e-6);
    scene.balls = {{{{1, 0, 1}, 0.25}, 1}};  // of glass, and yet it casts a shadow
    CHECK(seen(1, count) == 0);
    CHECK(seen(-0.5F, count) > 0);

    scene.balls.clear();
    scene.lights = {{{1, 0, -2}, {10, 10, 10}}};  // below: nothing is asked
    count        = {};
    CHECK(seen(1, count) == 0);
    CHECK(count.shadow_rays == 0);
}

TEST_CASE("recursion: a scene of opaque paint costs one ray a pixel and one to each light, however deep") {
    Scene box = cornell_box();
    box.lights.push_back({{278, 440, 279.5}, {1e5F, 1e5F, 1e5F}});
    const auto camera = convert<float>(cornell_box_camera(64));
    for (const int depth : {1, 32}) {
        const RecursiveTracer tracer(box, {.depth = depth});
        RayCount              count;
        (void)render(camera, {.samples = 1}, {},
                     [&](const Ray<float>& ray, Rng& rng) { return tracer.radiance(ray, rng, count); });
        CHECK(count.rays == 64U * 64);
        CHECK(count.shadow_rays <= 64U * 64);
        CHECK(count.shadow_rays > 64U * 32);
    }
}

TEST_CASE("recursion: where nothing is, the background is seen, also in a mirror") {
    Scene scene;
    scene.materials  = {mirror(0.5F)};
    scene.balls      = {{{{0, 0, 0}, 1}, 0}};
    scene.background = {1, 2, 3};
    CHECK(L_of(scene, {}, {{0, 0, 3}, {0, 1, 0}}) == 2);
    CHECK(L_of(scene, {}, {{0, 0, 3}, {0, 0, -1}}) == 1);
}

TEST_CASE("recursion: options out of range are refused by name and value") {
    const Scene scene = furnace(mirror(0.5F));
    CHECK_THROWS_WITH(RecursiveTracer(scene, {.depth = 0}), "recursion depth 0: must be 1 to 1000");
    CHECK_THROWS_AS(RecursiveTracer(scene, {.depth = 1001}), std::invalid_argument);
    CHECK_THROWS_WITH(RecursiveTracer(scene, {.cut_off = -0.5F}), "recursion cut-off -0.5: must be 0 to 1");
    CHECK_THROWS_AS(RecursiveTracer(scene, {.cut_off = std::nanf("")}), std::invalid_argument);
    CHECK_THROWS_WITH((void)grid_side(3), "3 samples a pixel: must be a square number, 1, 4, 9, ...");
    CHECK_THROWS_AS((void)grid_side(0), std::invalid_argument);
    CHECK_THROWS_AS((void)grid_side(-4), std::invalid_argument);
    CHECK(grid_side(144) == 12);
}

TEST_CASE("render: each sample has its own numbers, and they can be drawn again") {
    const auto              camera = convert<float>(cornell_box_camera(4));
    std::vector<float>      drawn;
    std::vector<float>      expected;
    constexpr PixelSampling sampling{.samples = 9, .seed = 7};
    (void)render(camera, sampling, {.threads = 1}, [&](const Ray<float>&, Rng& rng) {
        drawn.push_back(rng.uniform());
        return Spectrum{};
    });
    for (int y = 0; y < 4; ++y) {
        for (int x = 0; x < 4; ++x) {
            for (int sample = 0; sample < 9; ++sample)
                expected.push_back(Rng{sampling.seed, x, y, sample}.uniform());
        }
    }
    CHECK(drawn == expected);
    CHECK(std::set<float>(drawn.begin(), drawn.end()).size() == 4 * 4 * 9);
}

TEST_CASE("render: the same for any number of threads, and another for another seed") {
    const RecursiveTracer tracer(cornell_box_with_balls(), {.branching = Branching::random});
    const auto            camera = convert<float>(cornell_box_camera(48));
    const auto            with   = [&](int threads, std::uint64_t seed) {
        return render(camera, {.samples = 4, .seed = seed}, {.threads = threads},
                                   [&](const Ray<float>& ray, Rng& rng) {
                          RayCount count;
                          return tracer.radiance(ray, rng, count);
                      });
    };
    const auto one = with(1, 1);
    CHECK(one == with(7, 1));
    CHECK(!(one == with(1, 2)));
}
