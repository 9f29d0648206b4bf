/// @file emitters.cpp
/// Directions that are drawn to lights: irradiance by them is the closed form's, and their density is what it says.

#include "transport/emitters.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "radiometry/projected_solid_angle.hpp"
#include "sampling/rng.hpp"
#include "scene/small_scenes.hpp"
#include "statistics/running.hpp"
#include "statistics/tests.hpp"

using namespace sr;

namespace {

constexpr double          pi      = std::numbers::pi;
constexpr double          alpha   = 1e-5;  // significance of each test here; seeds are fixed
constexpr int             samples = 40'000;
constexpr std::array      all_ways{TriangleSampling::area, TriangleSampling::solid_angle,
                              TriangleSampling::by_distance};
const SurfacePoint<float> receiver{{0, 0, 0}, {0, 0, 1}, rounding_bound(1.0F)};

/// The irradiance at the receiver by directions that are drawn; `factor` is a planted error.
ZTest irradiance_test(const Scene& scene, TriangleSampling triangles, double expected, double factor = 1) {
    const Emitters        emitters(scene, triangles);
    const Surfaces<float> surfaces(scene);
    Rng                   rng{1, 0, 0, 0};
    Running               E;
    for (int i = 0; i < samples; ++i) {
        const float x = rng.uniform(), y = rng.uniform();
        const auto  light = emitters.sample(receiver, {x, y});
        const bool  lit   = light && light->direction.z > 0 && !surfaces.occluded(light->ray, light->range);
        E.add(lit ? double(light->direction.z * light->arriving.g) : 0);
    }
    return z_test(factor * E.mean(), std::max(E.standard_error(), 1e-6 * expected), expected);
}

struct LitScene {
    std::string name;
    Scene       scene;
    double      irradiance;  ///< [W/m^2]
};

Scene with_ball(double radius, const Vector3<double>& centre) {
    Scene scene;
    scene.materials = {grey(0, 2)};
    scene.balls     = {{Sphere<double>{centre, radius}, 0}};
    return scene;
}

Scene with_quad(const std::array<Vector3<double>, 4>& corners) {
    Scene scene;
    scene.materials = {grey(0, 2)};
    add_quad(scene, corners, 0);
    return scene;
}

double of_quad(const std::array<Vector3<double>, 4>& corners) {
    return 2 * projected_solid_angle(std::vector<Vector3<double>>(corners.begin(), corners.end())).value();
}

/// Of each kind one, some near and some partly below the horizon.
std::vector<LitScene> lit_scenes() {
    std::vector<LitScene> all;
    const Sphere<double>  above{{0.5, 0.25, 2}, 1}, setting{{2, 0, 0.5}, 1};
    all.push_back({"B3: ball", with_ball(1, above.centre), 2 * projected_solid_angle(above).value()});
    all.push_back(
        {"ball that sets", with_ball(1, setting.centre), 2 * projected_solid_angle(setting).value()});
    all.push_back({"inside a ball", with_ball(2, {0.5, 0.25, 0}), 2 * pi});
    const std::array<Vector3<double>, 4> lamp{{{-1, -1, 1}, {1, -1, 1}, {1, 1, 1}, {-1, 1, 1}}};
    const std::array<Vector3<double>, 4> near{{{-1, -1, 0.1}, {1, -1, 0.1}, {1, 1, 0.1}, {-1, 1, 0.1}}};
    const std::array<Vector3<double>, 4> high{{{-1, -1, 5}, {1, -1, 5}, {1, 1, 5}, {-1, 1, 5}}};
    const std::array<Vector3<double>, 4> wall{{{1, -1, -0.5}, {1, 1, -0.5}, {1, 1, 1}, {1, -1, 1}}};
    all.push_back({"B8: lamp above", with_quad(lamp), of_quad(lamp)});
    all.push_back({"lamp nearby", with_quad(near), of_quad(near)});
    all.push_back({"lamp afar", with_quad(high), of_quad(high)});
    all.push_back({"B9: wall", with_quad(wall), of_quad(wall)});
    Scene sky;
    sky.background = {2, 2, 2};
    all.push_back({"sky", sky, 2 * pi});
    Scene point;
    point.lights = {PointLight({0, 3, 4}, {7, 7, 7})};
    all.push_back({"B1: point light", point, 7 * 0.8 / 25});
    Scene several         = with_quad(lamp);  // of very different powers, and the quad hides some of the sky
    several.balls         = {{setting, 0}};
    several.lights        = point.lights;
    several.background    = {0.5, 0.5, 0.5};
    const double sky_left = pi - of_quad(lamp) / 2 - projected_solid_angle(setting).value();
    all.push_back({"all at once", several,
                   of_quad(lamp) + 2 * projected_solid_angle(setting).value() +
                       0.5 * sky_left});  // the point is hidden
    return all;
}

}  // namespace

TEST_CASE("emitters: irradiance by directions that are drawn is the closed form's") {
    for (const auto& [name, scene, E] : lit_scenes())
        for (const auto triangles : all_ways) {
            CAPTURE(name);
            CHECK(irradiance_test(scene, triangles, E).p > alpha);
        }
    // a density that is wrong by 2 % is found, where the variance is small
    const auto all = lit_scenes();
    for (const std::size_t i : {0U, 3U, 5U, 7U, 8U})
        CHECK(irradiance_test(all[i].scene, {}, all[i].irradiance, 1.02).p < alpha);
}

TEST_CASE(
    "emitters: a ray that was drawn meets what shines, and could have been drawn with the density that it "
    "was") {
    for (const auto& [name, scene, E] : lit_scenes())
        for (const auto triangles : all_ways) {
            CAPTURE(name);
            const Emitters        emitters(scene, triangles);
            const Surfaces<float> surfaces(scene);
            Rng                   rng{2, 0, 0, 0};
            int                   compared = 0, other = 0;
            for (int i = 0; i < 2000; ++i) {
                const float x = rng.uniform(), y = rng.uniform();
                const auto  light = emitters.sample(receiver, {x, y});
                if (!light || light->pdf.value == 0) continue;
                if (surfaces.occluded(light->ray, light->range)) continue;
                const auto   hit     = surfaces.nearest({light->ray.origin, light->direction});
                const double density = hit ? emitters.pdf(receiver, light->direction, *hit).value
                                           : emitters.pdf_of_background(receiver, light->direction).value;
                ++compared;
                other += std::abs(density / light->pdf.value - 1) < 1e-3 ? 0 : 1;
            }
            CHECK((compared > 200) == (name != "B1: point light"));
            CHECK(other <= 4);  // at the lamps' edges, rays pass by
        }
}

TEST_CASE("emitters: by distance is by solid angle near a triangle and by area far from it") {
    const auto drawn = [](double height, TriangleSampling triangles) {
        const Scene scene = with_quad({{{-1, -1, height}, {1, -1, height}, {1, 1, height}, {-1, 1, height}}});
        return Emitters(scene, triangles).sample(receiver, {0.3F, 0.6F})->direction;
    };
    using enum TriangleSampling;
    CHECK(drawn(1, by_distance) == drawn(1, solid_angle));
    CHECK(drawn(1, by_distance) != drawn(1, area));
    CHECK(drawn(6, by_distance) == drawn(6, area));
    CHECK(drawn(6, by_distance) != drawn(6, solid_angle));
}

TEST_CASE(
    "emitters: a lamp that shines from its front lights what lies before it, as one of two sides does") {
    const auto lit = [](std::array<Vector3<double>, 4> corners, bool shines_behind) {
        Scene scene                      = with_quad(corners);
        scene.materials[0].shines_behind = shines_behind;
        return Emitters(scene).sample(receiver, {0.3F, 0.6F});
    };
    const std::array<Vector3<double>, 4> up{{{-1, -1, 1}, {1, -1, 1}, {1, 1, 1}, {-1, 1, 1}}};
    const std::array<Vector3<double>, 4> down{up[3], up[2], up[1], up[0]};
    CHECK_FALSE(lit(up, false));
    CHECK(lit(up, true));
    REQUIRE(lit(down, false));
    CHECK(lit(down, false)->arriving == lit(down, true)->arriving);
}

TEST_CASE("emitters: where nothing shines nothing is drawn, and no lamp lights its own plane") {
    Scene dark;
    dark.materials = {grey(0.5F)};
    add_quad(dark, {{{-1, -1, 1}, {1, -1, 1}, {1, 1, 1}, {-1, 1, 1}}}, 0);
    CHECK_FALSE(Emitters(dark).sample(receiver, {0.5F, 0.5F}));
    dark.materials = {grey(0.5F, 1)};
    const SurfacePoint<float> beside{{3, 0, 1}, {0, 0, 1}, rounding_bound(4.0F)};
    for (const auto triangles : all_ways) {
        const auto light = Emitters(dark, triangles).sample(beside, {0.25F, 0.5F});
        if (light) CHECK(std::abs(light->direction.z) * light->arriving.g < 1e-4);
    }
}
