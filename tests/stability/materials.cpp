/// @file materials.cpp
/// Where the textbook's lobes, samplers and Fresnel formulas are NaN or wrong: rows S25, S26, S41 and S45.

#include <doctest/doctest.h>

#include <cmath>
#include <optional>
#include <tuple>

#include "../../chapters/06_materials/schlick.hpp"
#include "../../chapters/06_materials/textbook.hpp"
#include "material/diffuse.hpp"
#include "material/fresnel.hpp"
#include "material/mirror.hpp"
#include "material/phong.hpp"
#include "material/reflect.hpp"
#include "math/degrees.hpp"

using namespace sr;

namespace {

using V = Vector3<double>;

}  // namespace

TEST_CASE("S25: an unclamped lobe is light from behind it, or NaN; a clamped one is 0 there") {
    // 60 degrees on one side and 60 on the same: r.wi = cos 120 = -1/2
    const V w{std::sin(radians(60)), 0, std::cos(radians(60))};
    CHECK(std::abs(dot(reflect(w), w) + 0.5) <= 1e-15);
    CHECK(std::abs(textbook_phong(w, w, 10.0) - 0.000976562) <= 1e-9);
    CHECK(std::isnan(textbook_phong(w, w, 2.5)));
    const V normal{0, 0, 1}, along{1, 0, 0};
    CHECK(textbook_phong(normal, along, 0.0) == 1);  // pow(0, 0)
    for (const double e : {0.0, 2.5, 10.0}) {
        const Phong lobe(e, PhongScale::none);
        CHECK(lobe.f(w, w) == 0);
        CHECK(lobe.f(normal, along) == 0);
        CHECK(lobe.f(w, -reflect(w)) == 0);
        CHECK(lobe.f(-w, w) == 0);
        CHECK(lobe.f(normal, normal) == 1);
    }
}

TEST_CASE(
    "S26: a mirror that is evaluated is 0 / 0 at the horizon, and at the pole; one that is sampled is "
    "neither") {
    CHECK(std::isnan(textbook_mirror_light(0.8, 0.0)));        // (rho / cos) cos at theta = 90 degrees
    CHECK(std::isnan(textbook_polar_mirror_light(0.8, 0.0)));  // (rho / sin) sin at theta = 0
    CHECK(std::abs(textbook_mirror_light(0.8, 0.5) - 0.8) <= 1e-15);
    for (const V& wo : {V{0, 0, 1}, V{1, 0, 1e-300}, V{1, 0, 1e-9}}) {
        const auto one = Mirror<double>{}.sample(wo, {0.5, 0.5}, TransportMode::radiance);
        REQUIRE(one);
        CHECK(0.8 * one->weight == 0.8);
        CHECK(one->wi == reflect(wo));
    }
}

TEST_CASE(
    "S41: a random number of exactly 1 is 0 / 0 in f cos / pdf; weights that are cancelled stay finite") {
    CHECK(sample_cosine_hemisphere(Vec2{1, 0.5F}).z == 0);
    CHECK(std::isnan(textbook_diffuse_weight(0.5, {1, 0.5})));
    CHECK(std::abs(textbook_diffuse_weight(0.5, {0.3, 0.5}) - 0.5) <= 1e-15);

    const Vec2 last{1 - 0x1p-24F, 1 - 0x1p-24F};  // the largest that the generator gives
    const Vec3 wo{0, 0, 1};
    for (const Vec2& u : {last, Vec2{0, 0}, Vec2{0, 1 - 0x1p-24F}}) {
        const auto diffuse = Diffuse<float>{}.sample(wo, u, TransportMode::radiance);
        REQUIRE(diffuse);
        CHECK((diffuse->weight == 1 && diffuse->wi.z > 0 && diffuse->pdf.value > 0));
        for (const float e : {0.0F, 1.0F, 20.0F, 1000.0F, 1e6F}) {
            CAPTURE(e);
            const auto glossy = Phong{e}.sample(wo, u, TransportMode::radiance);
            REQUIRE(glossy);
            CHECK((glossy->weight > 0 && glossy->weight <= 2));
            CHECK((glossy->wi.z > 0 && std::isfinite(glossy->pdf.value) && glossy->pdf.value > 0));
        }
    }
    // even a 1 does no harm: the weight needs no division
    CHECK(Diffuse<float>{}.sample(wo, {1, 0.5F}, TransportMode::radiance)->weight == 1);
}

TEST_CASE("S45: Schlick's cosine from inside glass is a few percent where all light is reflected") {
    for (const auto& [angle, textbook, exact, cured] : {std::tuple{30.0, 0.0400, 0.0552, 0.0443},
                                                        {40.0, 0.0407, 0.2453, 0.2456},
                                                        {41.0, 0.0409, 0.3798, 0.4010},
                                                        {41.8, 0.0410, 0.8908, 0.9075},
                                                        {60.0, 0.0700, 1.0, 1.0}}) {
        CAPTURE(angle);
        const double c = std::cos(radians(angle)), eta = 1 / 1.5;
        CHECK(std::abs(textbook_schlick(c, eta) - textbook) <= 6e-5);
        CHECK(std::abs(fresnel(c, eta).mean() - exact) <= 6e-5);
        CHECK(std::abs(schlick(c, eta) - cured) <= 6e-5);
        CHECK(std::abs(schlick(c, eta) - fresnel(c, eta).mean()) <= 0.0357);  // F5: as far off as outside
    }
}
