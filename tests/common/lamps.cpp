/// @file lamps.cpp
/// Point lights in place of a scene's lamps, and what they light.

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

#include "scene/cornell_box.hpp"
#include "scene/lamps.hpp"
#include "scene/small_scenes.hpp"
#include "transport/recursion.hpp"

using namespace sr;

namespace {

constexpr std::uint32_t paint = 0, lamp = 1;

/// A closed lamp with edges of 1.
void add_cube(Scene& scene, const Vector3<double>& centre) {
    const auto first = std::uint32_t(scene.mesh.vertices.size());
    for (int i = 0; i < 8; ++i) {
        const Vector3<double> corner(i & 1, i >> 1 & 1, i >> 2 & 1);
        scene.mesh.vertices.push_back(centre + corner - 0.5);
    }
    constexpr std::array<std::array<std::uint32_t, 4>, 6> sides{
        {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}};
    for (const auto& [a, b, c, d] : sides) {
        scene.mesh.faces.push_back({first + a, first + b, first + c});
        scene.mesh.faces.push_back({first + a, first + c, first + d});
        scene.material_of_face.insert(scene.material_of_face.end(), 2, lamp);
    }
}

/// A floor of white paint at z = 0 and a ceiling at z = 8.
Scene hall() {
    Scene scene;
    scene.materials = {diffuse_material("paint", {1, 1, 1}), diffuse_material("lamp", {}, {8, 4, 2})};
    add_quad(scene, {{{-9, -9, 0}, {9, -9, 0}, {9, 9, 0}, {-9, 9, 0}}}, paint);
    add_quad(scene, {{{-9, -9, 8}, {9, -9, 8}, {9, 9, 8}, {-9, 9, 8}}}, paint);
    return scene;
}

/// What is seen from the side at (x, 0, z), where the hall's lamps are lights.
double seen_at(Scene scene, float x, float z) {
    scene.lights = lights_of_lamps(scene);
    const Vec3 from{x + 4, 0, 4};
    Rng        rng{1, 0, 0, 0};
    RayCount   count;
    return double(RecursiveTracer(scene).radiance({from, Vec3{x, 0, z} - from}, rng, count).r);
}

}  // namespace

TEST_CASE("lamps: a flat one's light is in its middle, with its normal intensity L A") {
    const Scene box    = cornell_box();
    const auto  lights = lights_of_lamps(box);
    REQUIRE(lights.size() == 1);
    // the lamp is the rectangle of 130 x 105 from (213, 227) to (343, 332), 0.1 below 548.8
    CHECK(length(lights[0].position() - Vector3<double>{278, 548.7, 279.5}) <= 1e-9);
    CHECK(std::abs(lights[0].intensity().r / (17.0F * 130 * 105) - 1) <= 1e-6F);
    CHECK(std::abs(lights[0].intensity().b / (4.0F * 130 * 105) - 1) <= 1e-6F);
}

TEST_CASE("lamps: a closed one has one light in its middle, with the intensity of its mean silhouette") {
    Scene scene = hall();
    add_cube(scene, {1, 2, 4});
    const auto lights = lights_of_lamps(scene);
    REQUIRE(lights.size() == 1);
    CHECK(length(lights[0].position() - Vector3<double>{1, 2, 4}) <= 1e-12);
    CHECK(std::abs(lights[0].intensity().r / (8 * 6 / 4.0F) - 1) <= 1e-6F);
}

TEST_CASE("lamps: two of one material are two lights, also beside each other, and paint is none") {
    Scene scene = hall();
    CHECK(lights_of_lamps(scene).empty());
    for (const double x : {-3.0, 3.0})
        add_quad(scene, {{{x, 0, 7}, {x, 1, 7}, {x + 2, 1, 7}, {x + 2, 0, 7}}}, lamp);
    add_cube(scene, {0, 0, 4});
    const auto lights = lights_of_lamps(scene);
    REQUIRE(lights.size() == 3);
    for (const Vector3<double> at : {Vector3<double>{-2, 0.5, 7}, {4, 0.5, 7}, {0, 0, 4}}) {
        CHECK(std::ranges::count_if(lights, [&](const PointLight& light) {
                  return length(light.position() - at) <= 1e-12;
              }) == 1);
    }
}

TEST_CASE(
    "lamps: one lights what is around it by I cos / r^2, and hides neither its own light nor another's") {
    const double to_paint = 1 / std::numbers::pi;
    Scene        flat     = hall();
    add_quad(flat, {{{-1, -1, 6}, {-1, 1, 6}, {1, 1, 6}, {1, -1, 6}}}, lamp);
    CHECK(std::abs(seen_at(flat, 0, 0) / (to_paint * 8 * 4 / 36) - 1) <= 1e-5);

    Scene cube = hall();
    add_cube(cube, {0, 0, 6});
    CHECK(std::abs(seen_at(cube, 0, 0) / (to_paint * 12 / 36) - 1) <= 1e-5);
    CHECK(std::abs(seen_at(cube, 0, 8) / (to_paint * 12 / 4) - 1) <= 1e-5);

    add_cube(cube, {0, 0, 3});
    CHECK(std::abs(seen_at(cube, 0, 0) / (to_paint * 12 * (1 / 36.0 + 1 / 9.0)) - 1) <= 1e-5);
    // the control: what does not shine does
    add_quad(cube, {{{-1, -1, 2}, {1, -1, 2}, {1, 1, 2}, {-1, 1, 2}}}, paint);
    CHECK(seen_at(cube, 0, 0) == 0);
}
