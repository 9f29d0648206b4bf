/// @file materials.cpp
/// What the lobes are built of, and their sum. The laws that all lobes obey have a file of their own.

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>
#include <stdexcept>

#include "bsdf_laws.hpp"
#include "material/lobe_sum.hpp"
#include "math/degrees.hpp"
#include "sampling/rng.hpp"

namespace {

using namespace sr;
using test::at_angle;
using V = test::Direction;

// What may be evaluated, and what only sampled, is known to the compiler.
static_assert(Bsdf<Diffuse<float>, float> && Bsdf<Diffuse<double>, double>);
static_assert(Bsdf<LobeSum<float>, float, Spectrum> && !Bsdf<LobeSum<float>, float>);
static_assert(DeltaLobe<Mirror<float>, float> && DeltaLobe<Dielectric<double>, double>);
static_assert(!Bsdf<Mirror<float>, float> && !DeltaLobe<Diffuse<float>, float>);

}  // namespace

TEST_CASE("F1: Fresnel reflectance at normal incidence is ((n - 1) / (n + 1))^2") {
    for (const auto& [n, R] :
         {std::pair{4.0 / 3, 0.020408163265306122}, {1.5, 0.04}, {2.42, 0.17239492493416778}}) {
        CHECK(std::abs(fresnel(1.0, n).mean() / R - 1) <= 1e-14);
        CHECK(std::abs(fresnel(1.0, 1 / n).mean() / R - 1) <= 1e-14);
    }
}

TEST_CASE("F2: Fresnel reflectance from air to glass") {
    struct Row {
        double degrees, s, p;
    };
    for (const auto& [degrees, s, p] : {Row{30, 0.057796105403213094, 0.025249146548429986},
                                        Row{45, 0.092013363045524405, 0.0084664589789474762},
                                        Row{60, 0.17657148808284053, 0.0018019375215850362},
                                        Row{75, 0.39935602700039498, 0.10676509898024435},
                                        Row{85, 0.73234547871080145, 0.49325381181885332}}) {
        const auto R = fresnel(std::cos(radians(degrees)), 1.5);
        CHECK(std::abs(R.s / s - 1) <= 1e-12);
        CHECK(std::abs(R.p / p - 1) <= 1e-12);
        CHECK(std::abs(R.mean() - (s + p) / 2) <= 1e-13);
    }
}

TEST_CASE("reflection: to the other side of the normal, out of any plane") {
    CHECK(reflect(V{0.48, -0.6, 0.64}) == V{-0.48, 0.6, 0.64});
}

TEST_CASE("refraction: Snell's law, from either side, and the way back") {
    Rng rng{1, 0, 0, 0};
    for (int i = 0; i < 1000; ++i) {
        const double u = rng.uniform<double>(), v = rng.uniform<double>();
        V            w   = sample_uniform_hemisphere(Vector2<double>{u, v});
        const double eta = 0.5 + 2 * rng.uniform<double>();
        if (i % 2 == 1) w.z = -w.z;
        const auto t = refract(w, eta);
        CHECK(t.has_value() == (std::hypot(w.x, w.y) < eta));
        if (!t) continue;
        CHECK(std::abs(length(*t) - 1) <= 1e-14);
        CHECK(t->z * w.z < 0);
        CHECK(std::hypot(w.x + eta * t->x, w.y + eta * t->y) <= 1e-15);
        const auto back = refract(*t, 1 / eta);
        REQUIRE(back.has_value());
        CHECK(length(*back - w) <= 1e-13 / std::abs(w.z));  // near the border the angle is ill-conditioned
    }
}

TEST_CASE("F6: radiance is scaled by n^2 where it is refracted, importance is not") {
    const Dielectric glass{1.5};
    // radiance that arrives from the air, seen inside: L_t = (1 - R) n^2 L_i
    CHECK(std::abs(glass.branches({0, 0, -1}, TransportMode::radiance).refracted->weight / 2.16 - 1) <=
          1e-14);
    const V inside = *refract(at_angle(60), 1.5);
    CHECK(std::abs(glass.branches(inside, TransportMode::radiance).refracted->weight / 2.0493298961950212 -
                   1) <= 1e-14);
    for (const double degrees : {0.0, 30.0, 60.0, 89.0}) {
        const auto both = glass.branches(at_angle(degrees), TransportMode::importance);
        CHECK(std::abs(both.reflected.weight + both.refracted->weight - 1) <= 1e-15);
    }
}

TEST_CASE("dielectric: what is drawn counts what its branch does, as often as it is drawn") {
    const Dielectric glass{1.5};
    const V          wo   = at_angle(75);
    const auto       both = glass.branches(wo, TransportMode::radiance);
    const double     R    = both.reflected.weight;
    CHECK(std::abs(R - 0.25306056299031967) <= 1e-13);
    CHECK(glass.sample(wo, {R * (1 - 1e-12), 0}, TransportMode::radiance)->wi == both.reflected.wi);
    CHECK(glass.sample(wo, {R * (1 + 1e-12), 0}, TransportMode::radiance)->wi == both.refracted->wi);
    CHECK(std::abs(glass.sample(wo, {0, 0}, TransportMode::radiance)->weight - 1) <= 1e-15);
    CHECK(std::abs(glass.sample(wo, {0.9, 0}, TransportMode::radiance)->weight - 1 / 2.25) <= 1e-15);
    CHECK(!glass.branches({std::sin(1.0), 0, -std::cos(1.0)}, TransportMode::radiance).refracted);
    CHECK(
        glass.sample({std::sin(1.0), 0, -std::cos(1.0)}, {1 - 0x1p-53, 0}, TransportMode::radiance)->weight ==
        1);
}

TEST_CASE("dielectric: a number of exactly 1 draws what is there") {
    const Dielectric glass{1.5};
    const V          total{std::sin(1.0), 0, -std::cos(1.0)}, along{1, 0, 1e-300};
    for (const V& wo : {total, along}) {  // there is no other way, or one without light
        CHECK(glass.branches(wo, TransportMode::radiance).reflected.weight == 1);
        const auto one = glass.sample(wo, {1, 1}, TransportMode::radiance);
        REQUIRE(one);
        CHECK(one->wi == reflect(wo));
        CHECK(one->weight == 1);
    }
    CHECK(glass.sample(at_angle(75), {1, 1}, TransportMode::radiance)->wi.z < 0);
}

TEST_CASE("dielectric: an impossible index of refraction is refused by name and value") {
    for (const double n : {0.0, -1.5, std::nan(""), HUGE_VAL}) {
        CHECK_THROWS_AS(Dielectric<double>{n}, std::invalid_argument);
    }
    CHECK_THROWS_WITH(Dielectric<double>{0},
                      "index of refraction is 0; it must be positive and finite, such as 1.5 for glass");
}

TEST_CASE("lobe sum: f adds up, and samples count f cos / pdf of the whole") {
    const Spectrum        red{0.5F, 0.2F, 0.1F}, grey{0.3F, 0.3F, 0.3F};
    const LobeSum<double> sum{{{red, Diffuse<double>{}}, {grey, Mirror<double>{}}}};
    const V               wo = at_angle(40), wi = at_angle(-10);
    CHECK(std::abs(sum.f(wo, wi).r - 0.5F * std::numbers::inv_pi_v<float>) <= 1e-7F);

    // 0.8 / 3 and 0.3: the lobes are chosen in the ratio of their mean weights
    const double diffuse = double(mean(red)) / (double(mean(red)) + double(mean(grey)));
    const auto   first   = sum.sample(wo, {0.99 * diffuse, 0.3}, TransportMode::radiance);
    const auto   second  = sum.sample(wo, {1.01 * diffuse, 0.3}, TransportMode::radiance);
    REQUIRE((first && second));
    CHECK(!first->is_delta);
    CHECK(second->is_delta);
    CHECK(second->wi == reflect(wo));
    // choosing is undone by the weight: its mean over u is the sum's albedo
    CHECK(std::abs(diffuse * double(first->weight.r) - 0.5) <= 1e-6);
    CHECK(std::abs((1 - diffuse) * double(second->weight.g) - 0.3) <= 1e-6);
    CHECK(std::abs(sum.pdf(wo, first->wi).value - first->pdf.value) <= 1e-15);
}

TEST_CASE("lobe sum: without light nothing is drawn, and more light than arrives is refused") {
    CHECK(!LobeSum<float>{}.sample({0, 0, 1}, {0.5F, 0.5F}, TransportMode::radiance));
    CHECK(!LobeSum<float>{{{{}, Diffuse<float>{}}}}.sample({0, 0, 1}, {0.5F, 0.5F}, TransportMode::radiance));
    const auto refused = [](std::vector<WeightedLobe<float>> lobes) {
        return LobeSum<float>{std::move(lobes)};
    };
    CHECK_THROWS_WITH((void)refused({{{1.5F, 0, 0}, Diffuse<float>{}}}),
                      "a lobe's weight is (1.5, 0, 0); each must be from 0 to 1");
    CHECK_THROWS_WITH((void)refused({{{0, -0.5F, 0}, Mirror<float>{}}}),
                      "a lobe's weight is (0, -0.5, 0); each must be from 0 to 1");
    CHECK_THROWS_AS((void)refused({{{0, 0, std::nanf("")}, Mirror<float>{}}}), std::invalid_argument);
    CHECK_THROWS_WITH((void)refused({{{0.75F, 0, 0}, Diffuse<float>{}}, {{0.5F, 0, 0}, Mirror<float>{}}}),
                      "the albedo of the lobes' sum is (1.25, 0, 0); each must be from 0 to 1");
    CHECK_NOTHROW(
        (void)refused({{{0.7F, 0.6F, 0.9F}, Diffuse<float>{}}, {{0.3F, 0.4F, 0.1F}, Mirror<float>{}}}));
}
