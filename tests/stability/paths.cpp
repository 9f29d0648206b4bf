/// @file paths.cpp
/// S48: samples that are no numbers, along millions of paths: none where the scene is sound, and where it is not one
/// that says which.

#include <doctest/doctest.h>

#include <cmath>
#include <cstdint>
#include <cstdio>
#include <string>
#include <utility>
#include <vector>

#include "sampling/random_point.hpp"
#include "scene/cornell_box.hpp"
#include "scene/scene_view.hpp"
#include "scene/small_scenes.hpp"
#include "scene/teapot.hpp"
#include "transport/traced.hpp"

using namespace sr;

namespace {

struct Viewed {
    std::string    name;
    Scene          scene;
    Camera<double> camera;
};

Camera<double> looking(const Vector3<double>& from, const Vector3<double>& to, int side) {
    return pinhole_camera<double>(from, to - from, {0, 1, 0}, 1, 1, side, side);
}

/// A room with every material there is, a lamp that lies on its floor and one that is a speck.
Scene room_of_all() {
    Scene scene;
    scene.materials = {grey(0.9F), grey(0.5F), grey(1), grey(0.2F), grey(0), grey(0.7F)};
    add_cube(scene, -1, 1);
    const Spectrum white{1, 1, 1}, half{0.5F, 0.5F, 0.5F};
    scene.materials.push_back({"glass", LobeSum<float>{{{white, Dielectric<float>{1.5F}}}}});
    scene.materials.push_back({"mirror", LobeSum<float>{{{white, Mirror<float>{}}}}});
    scene.materials.push_back(
        {"gloss", LobeSum<float>{{{half, Diffuse<float>{}}, {half, Phong<float>{1e5F}}}}});
    scene.materials.push_back(grey(0.5F, 1e4F));
    add_quad(scene, {{{-0.1, -1, -0.1}, {-0.1, -1, 0.1}, {0.1, -1, 0.1}, {0.1, -1, -0.1}}}, 9);
    scene.balls = {{{{0.5, -0.5, 0}, 0.5}, 6},   // touches two walls
                   {{{-0.5, -0.5, 0}, 0.5}, 7},  // and all three each other
                   {{{0, 0.4, 0}, 0.3}, 8},
                   {{{0.3, 0.8, 0.3}, 1e-4}, 9}};
    return scene;
}

std::vector<Viewed> all_scenes(int side) {
    std::vector<Viewed> all;
    all.push_back({"Cornell box", cornell_box(), cornell_box_camera(side)});
    all.push_back({"with balls", cornell_box_with_balls(), cornell_box_camera(side)});
    all.push_back({"room of all", room_of_all(), looking({-0.9, -0.9, -0.9}, {0, 0, 0}, side)});
    all.push_back({"on the glass", room_of_all(), looking({0.5, -0.5, -0.5}, {-0.5, -0.5, 0.2}, side)});
    all.push_back({"furnace", inside_of_a_ball(1, 1), looking({0, 0, 0}, {0, 0, 1}, side)});
    Scene pot;
    pot.mesh       = teapot(4);
    pot.materials  = {{"china", room_of_all().materials[8].scattering, {}}};
    pot.background = {1, 1, 1};
    pot.material_of_face.assign(pot.mesh.faces.size(), 0);
    all.push_back({"teapot", pot, looking({0, -9, 3}, {0, 0, 1}, side)});
    return all;
}

}  // namespace

TEST_CASE("ten million paths through all kinds of scenes have no sample that is no number") {
    constexpr int side = 64, samples = 84;  // in each of six scenes by each of five strategies
    std::uint64_t paths = 0;
    for (const auto& [name, scene, camera] : all_scenes(side))
        for (const auto strategy :
             {Strategy::blind, Strategy::bsdf, Strategy::light, Strategy::balance, Strategy::power}) {
            CAPTURE(name);
            CAPTURE(int(strategy));
            const PathOptions options{.strategy = strategy, .bounces = 100};
            CHECK_NOTHROW(
                paths +=
                traced(scene, camera, options, {.seed = 48, .samples = samples}, {.threads = 0}).samples());
        }
    CHECK(paths > 10'000'000);
}

TEST_CASE("a material whose light adds up to no number is told with the pixel and the sample where it did") {
    const Scene ball = inside_of_a_ball(0.9F, 1e38F);  // ten times as much in all, and a float ends at 3.4e38
    const auto  camera = looking({0, 0, 0}, {0, 0, 1}, 16);
    std::string told   = "nothing";
    try {
        static_cast<void>(traced<RandomPoint>(ball, camera, {}, {.samples = 8}, {}));
    } catch (const BadSample& error) {
        told = error.what();
    }
    int x = -1, y = -1, sample = -1;
    REQUIRE(std::sscanf(told.c_str(), "sample %d of pixel (%d, %d)", &sample, &x, &y) == 3);
    RandomPoint    point(SampleId{hash(1, 0), x, y, std::uint32_t(sample), 8});  // again, alone
    PathCount      count;
    const Vec2     at = Vec2{x, y} + point.pair<float>();
    const Spectrum L  = PathTracer(ball).radiance(convert<float>(camera).ray(at), point, count);
    CHECK_FALSE(std::isfinite(L.r + L.g + L.b));
}
