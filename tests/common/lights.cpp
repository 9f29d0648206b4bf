/// @file lights.cpp
/// What a scene is made of and lit by, and what it may not be.

#include <doctest/doctest.h>

#include <fmt/format.h>

#include <cmath>
#include <string>

#include "scene/cornell_box.hpp"
#include "scene/scene.hpp"
#include "scene/surfaces.hpp"

using namespace sr;

namespace {

/// A unit sphere of one material around the origin.
Scene ball_of(Material material) {
    Scene scene;
    scene.materials.push_back(std::move(material));
    scene.balls = {{{{0, 0, 0}, 1}, 0}};
    return scene;
}

}  // namespace

TEST_CASE("lights: one that can't be is refused by name and value") {
    CHECK_THROWS_WITH((PointLight{{0, 0, 0}, {1, -2, 0}}),
                      "intensity of a point light is (1, -2, 0); each must be finite and not negative");
    CHECK_THROWS_WITH((PointLight{{0, 0, 0}, {std::nanf(""), 0, 0}}),
                      "intensity of a point light is (nan, 0, 0); each must be finite and not negative");
    CHECK_THROWS_WITH((PointLight{{0, 0, 0}, {0, 0, HUGE_VALF}}),
                      "intensity of a point light is (0, 0, inf); each must be finite and not negative");
    CHECK_THROWS_WITH((PointLight{{0, HUGE_VAL, 0}, {1, 1, 1}}),
                      "position of a point light is (0, inf, 0); each must be finite, also in float");
    CHECK_THROWS_WITH((PointLight{{1e300, 0, 0}, {1, 1, 1}}),
                      "position of a point light is (1e+300, 0, 0); each must be finite, also in float");
    CHECK(PointLight{{1, 2, 3}, {4, 5, 6}}.intensity() == Spectrum{4, 5, 6});
}

TEST_CASE("scene: what can't be is refused by name and value") {
    CHECK_NOTHROW(check_scene(ball_of(diffuse_material("chalk", {0.5F, 0.5F, 0.5F}))));
    CHECK_THROWS_WITH(check_scene(ball_of(diffuse_material("lamp", {}, {1, -1, 0}))),
                      "material 'lamp' emits (1, -1, 0); each must be finite and not negative");
    CHECK_THROWS_WITH(check_scene(ball_of(diffuse_material("lamp", {}, {std::nanf(""), 0, 0}))),
                      "material 'lamp' emits (nan, 0, 0); each must be finite and not negative");
    CHECK_THROWS_WITH((void)diffuse_material("chalk", {1.5F, 0, 0}),
                      "reflectance of material 'chalk' is (1.5, 0, 0); each must be from 0 to 1");
    CHECK_THROWS_WITH((void)diffuse_material("chalk", {0, std::nanf(""), 0}),
                      "reflectance of material 'chalk' is (0, nan, 0); each must be from 0 to 1");

    Scene dark      = ball_of(diffuse_material("chalk", {}));
    dark.background = {0, 0, -1};
    CHECK_THROWS_WITH(check_scene(dark), "background emits (0, 0, -1); each must be finite and not negative");

    Scene missing             = ball_of(diffuse_material("chalk", {}));
    missing.balls[0].material = 1;
    CHECK_THROWS_WITH(check_scene(missing), "ball 0 has material 1, of which there are 1; must be less");
    Scene bare = cornell_box();
    bare.material_of_face.pop_back();
    CHECK_THROWS_WITH(check_scene(bare), "32 faces, and materials for 31 of them; must be as many");
}

TEST_CASE("scene: a ball must have a place and a radius, also in float") {
    Scene scene = ball_of(diffuse_material("chalk", {}));
    for (const double radius : {0.0, -1.0, 1e-60, 1e60, std::nan("")}) {
        scene.balls[0].sphere.radius = radius;
        CHECK_THROWS_WITH(
            Surfaces<float>{scene},
            fmt::format("ball 0 has a radius of {}; must be from 1.1754944e-38 to 3.4028235e+38, as in float",
                        radius)
                .c_str());
    }
    scene.balls[0].sphere = {{0, std::nan(""), HUGE_VAL}, 1};
    CHECK_THROWS_WITH(check_scene(scene),
                      "ball 0 has its centre at (0, nan, inf); each must be finite, also in float");
}

TEST_CASE("scene: a face must have vertices that there are, each at a place, also in float") {
    Scene scene = cornell_box();
    CHECK_NOTHROW(check_scene(scene));
    const auto last     = std::uint32_t(scene.mesh.vertices.size() - 1);
    scene.mesh.faces[3] = {0, 1, last + 1};
    CHECK_THROWS_WITH(
        Surfaces<float>{scene},
        fmt::format("face 3 has vertex {0}, of which there are {0}; must be less", last + 1).c_str());
    scene.mesh.faces[3]       = {0, 1, 2};
    scene.material_of_face[4] = 9;
    CHECK_THROWS_WITH(check_scene(scene), "face 4 has material 9, of which there are 4; must be less");
    scene.material_of_face[4] = 0;
    for (const double far : {1e300, -1e39, HUGE_VAL, std::nan("")}) {
        scene.mesh.vertices.emplace_back(0, 0, far);
        CHECK_NOTHROW(check_scene(scene));  // no face has it
        scene.mesh.faces[5] = {0, std::uint32_t(scene.mesh.vertices.size() - 1), 1};
        CHECK_THROWS_WITH(
            check_scene(scene),
            fmt::format("face 5 has a corner at (0, 0, {}); each must be finite, also in float", far)
                .c_str());
        scene.mesh.faces[5] = {0, 1, 2};
    }
}

TEST_CASE("scene: the reflectance is the sum of the lobes' weights; light goes through glass only") {
    const Material paint{"varnish", LobeSum<float>{{{{0.5F, 0.25F, 0}, Diffuse<float>{}},
                                                    {{0.25F, 0.25F, 0.25F}, Mirror<float>{}}}}};
    const Material glass{"glass", LobeSum<float>{{{{1, 1, 1}, Dielectric<float>{1.5F}}}}};
    CHECK(paint.reflectance() == Spectrum{0.75F, 0.5F, 0.25F});
    CHECK(!paint.is_transparent());
    CHECK(glass.is_transparent());
    CHECK(Material{"soot"}.reflectance() == Spectrum{});
}

TEST_CASE_TEMPLATE("surfaces: the nearest of triangles and balls, from either side", T, float, double) {
    Scene             scene = cornell_box_with_balls();
    const Surfaces<T> surfaces(scene);
    // along z at the height of the glass ball's centre: its front, then from inside its back, then the wall
    const auto        front = surfaces.nearest({{165, 95, -100}, {0, 0, 1}});
    REQUIRE(front);
    CHECK(std::abs(double(front->t) - 195) <= 1e-3);
    CHECK(scene.materials[front->material].name == "glass");
    CHECK(length(front->point.normal - Vector3<T>{0, 0, -1}) <= T(1e-6));
    const auto back = surfaces.nearest({{165, 95, 190}, {0, 0, 1}});
    REQUIRE(back);
    CHECK(std::abs(double(back->t) - 95) <= 1e-4);
    const auto wall = surfaces.nearest({{165, 300, -100}, {0, 0, 1}});
    REQUIRE(wall);
    CHECK(std::abs(double(wall->t) - 659.2) <= 1e-3);
    CHECK(scene.materials[wall->material].name == "white");
    CHECK(!surfaces.nearest({{165, 95, -100}, {0, 0, -1}}));

    CHECK(surfaces.occluded({{165, 95, -100}, {0, 0, 1}}, {0, 200}));
    CHECK(!surfaces.occluded({{165, 95, -100}, {0, 0, 1}}, {0, 190}));
    CHECK(surfaces.occluded({{165, 300, -100}, {0, 0, 1}}, {0, 700}));
    CHECK(!surfaces.occluded({{165, 300, -100}, {0, 0, 1}}, {0, 650}));
}

TEST_CASE_TEMPLATE("surfaces: of a triangle and the balls before and behind it, the first is met", T, float,
                   double) {
    Scene scene;
    for (const std::string name : {"front", "sheet", "back"})
        scene.materials.push_back(diffuse_material(name, {}));
    scene.mesh             = {{{-9, -9, 0}, {9, -9, 0}, {0, 9, 0}}, {{0, 1, 2}}};
    scene.material_of_face = {1};
    scene.balls            = {{{{0, 0, -3}, 1}, 2}, {{{0, 0, 3}, 1}, 0}};
    const Surfaces<T> surfaces(scene);
    for (const T side : {T{1}, T{-1}}) {
        const auto from = [&](T z) { return surfaces.nearest({{0, 0, side * z}, {0, 0, -side}}); };
        const auto ball = from(5), sheet = from(1), beyond = from(-1);
        REQUIRE((ball && sheet && beyond));
        CHECK(ball->t == 1);
        CHECK(ball->material == (side > 0 ? 0 : 2));
        CHECK(sheet->t == 1);
        CHECK(sheet->material == 1);
        CHECK(beyond->t == 1);
        CHECK(beyond->material == (side > 0 ? 2 : 0));
    }
}

TEST_CASE("surfaces: a triangle too small for its normal faces the ray that found it") {
    Scene scene;
    scene.materials        = {diffuse_material("dust", {1, 1, 1})};
    const double s         = 1e-15;  // the squared area, 10^-60, is no float
    scene.mesh             = {{{0, 0, 0}, {s, 0, 0}, {0, s, 0}}, {{0, 1, 2}}};
    scene.material_of_face = {0};
    const Surfaces<float> surfaces(scene);
    const auto            hit = surfaces.nearest({{float(s / 4), float(s / 4), float(s)}, {0, 0, -2}});
    if (hit) CHECK(hit->point.normal == Vec3{0, 0, 1});
    CHECK(hit.has_value());
}
