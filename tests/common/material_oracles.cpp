/// @file material_oracles.cpp
/// Albedos of lobes and reflectances of surfaces, against closed forms and published values.

#include <doctest/doctest.h>

#include <cmath>
#include <complex>
#include <numbers>
#include <stdexcept>
#include <tuple>
#include <utility>

#include "../../chapters/06_materials/conductor.hpp"
#include "../../chapters/06_materials/schlick.hpp"
#include "bsdf_laws.hpp"
#include "material/checker.hpp"
#include "material/lobe_sum.hpp"
#include "material/phong_albedo.hpp"
#include "near.hpp"

using namespace sr;
using namespace sr::test;

namespace {

using std::numbers::pi;

double phong_albedo_at(double e, double degrees) {
    return phong_albedo(e, radians(degrees));
}

/// The unpolarised reflectance, averaged over directions by the cosine: 2 R(cos) cos d(cos), between two cosines. At
/// either of them the slope may be infinite: the points crowd there.
double diffuse_reflectance(double eta, double from, double to) {
    double sum = 0;
    for (const auto& [x, weight] : gauss_legendre(64, 0, pi)) {
        const double c = from + (to - from) * (1 - std::cos(x)) / 2;
        sum += weight * std::sin(x) / 2 * (to - from) * 2 * c * fresnel(c, eta).mean();
    }
    return sum;
}

}  // namespace

TEST_CASE("E1: the albedo of the diffuse lobe is its reflectance; without 1 / pi it would be pi times that") {
    for (const Direction& wo : views()) CHECK(0.5 * albedo(Diffuse<double>{}, wo, 8) == near(0.5));
    double without_pi = 0;
    for (const auto& [wi, weight] : hemisphere_rule(8)) without_pi += weight * 0.5 * wi.z;
    CHECK(without_pi == near(1.5707963267948966));
}

TEST_CASE("E2, E3: Phong's lobe as it is, at normal and at grazing incidence") {
    for (const auto& [e, normal, grazing] : {std::tuple{1.0, 2.0943951023931955, 0.66666666666666667},
                                             {2, 1.5707963267948966, 0.39269908169872415},
                                             {5, 0.89759790102565521, 0.15238095238095238},
                                             {10, 0.52359877559829887, 0.064427193091196932},
                                             {50, 0.12083048667653051, 0.006783131877052344},
                                             {100, 0.061599855952741044, 0.0024513427792193618},
                                             {1000, 0.0062706440191413039, 7.9088554686434415e-5}}) {
        CAPTURE(e);
        CHECK(phong_albedo_at(e, 0) == near(normal));
        CHECK(phong_albedo_at(e, 90) == near(grazing));
        CHECK(Phong(e, PhongScale::none).greatest_albedo() == near(normal));
        CHECK(std::beta((e + 1) / 2, 1.5) == near(grazing));
    }
    // between them, the closed form in one integral against the integral over the hemisphere
    for (const double degrees : {0.0, 30.0, 60.0, 85.0}) {
        CAPTURE(degrees);
        CHECK(albedo(Phong(10.0, PhongScale::none), at_angle(degrees)) == near(phong_albedo_at(10, degrees)));
    }
}

TEST_CASE("E5: up to e = 2 pi rho - 2 Phong's lobe gives back more light than it gets, and no sum takes it") {
    for (const auto& [rho, border] : {std::pair{1.0, 4.2831853071795865}, {0.5, 1.1415926535897932}}) {
        CAPTURE(rho);
        CHECK(rho * Phong(border, PhongScale::none).greatest_albedo() == near(1));
        const float kept   = float(rho);
        const auto  refuse = [&](double e) {
            return LobeSum<double>{{{{kept, kept, kept}, Phong(e, PhongScale::none)}}};
        };
        CHECK_THROWS_AS((void)refuse(border - 0.01), std::invalid_argument);
        CHECK_NOTHROW((void)refuse(border + 0.01));
    }
    CHECK(1 / Phong(1.0, PhongScale::none).greatest_albedo() == near(0.47746482927568601));
    CHECK(1 / Phong(10.0, PhongScale::none).greatest_albedo() == near(1.909859317102744));
    for (double e = 0; e < 20; e += 0.5) {  // the greatest is at normal incidence
        for (double degrees = 5; degrees <= 90; degrees += 5)
            CHECK(phong_albedo_at(e, degrees) < phong_albedo_at(e, degrees - 5));
    }
}

TEST_CASE("E6: a lobe that integrates to 1 has an albedo of (e + 1) / (e + 2) at most") {
    for (const auto& [e, normal, grazing] : {std::tuple{1.0, 0.66666666666666667, 0.21220659078919378},
                                             {10, 0.91666666666666667, 0.11279296875},
                                             {100, 0.99019607843137255, 0.039404475373063995}}) {
        CAPTURE(e);
        const Phong lobe(e, PhongScale::density);
        CHECK(lobe.greatest_albedo() == near(normal));
        CHECK((e + 1) / (2 * pi) * phong_albedo_at(e, 90) == near(grazing));
    }
}

TEST_CASE("E7: scaled to an albedo of 1 at normal incidence, the lobe darkens from there on") {
    const Phong lobe(10.0);
    CHECK(lobe.greatest_albedo() == near(1));
    for (const auto& [degrees, expected] :
         {std::pair{0.0, 1.0}, {45, 0.70737419137452376}, {75, 0.29190101516693487}, {90, 0.123046875}}) {
        CAPTURE(degrees);
        CHECK(12 / (2 * pi) * phong_albedo_at(10, degrees) == near(expected));
        if (degrees < 90) CHECK(albedo(lobe, at_angle(degrees)) == near(expected));
    }
}

TEST_CASE("E9: Phong's lobe as a density, its mean cosine and what of it falls below the horizon") {
    constexpr int   draws = 200'000;
    const Phong     lobe(10.0);
    const Direction wo = at_angle(75);
    Rng             rng{71, 0, 0, 0};
    Running         cosine, below;
    for (int i = 0; i < draws; ++i) {
        const double u = rng.uniform<double>(), v = rng.uniform<double>();
        cosine.add(sample_power_cosine(Vector2<double>{u, v}, 10.0).z);
        below.add(lobe.sample(wo, {u, v}, TransportMode::radiance) ? 0 : 1);
    }
    CHECK(std::abs(cosine.mean() - 0.91666666666666667) <= 5 * cosine.standard_error());
    CHECK(std::abs(below.mean() - 0.19659505828331642) <= 5 * below.standard_error());
    CHECK(!(std::abs(below.mean() - 0.19) <= 5 * below.standard_error()));  // it could tell
    double above = 0;
    for (const auto& [wi, weight] : hemisphere_rule(96)) above += weight * lobe.pdf(wo, wi).value;
    CHECK(1 - above == near(0.19659505828331642));
}

TEST_CASE("power cosine: sample, density and inverse belong together, in a narrow lobe, too") {
    for (const double e : {0.0, 1.0, 20.0, 1e4}) {
        CAPTURE(e);
        for (const Vector2<double> u : {Vector2<double>{0.1, 0.2}, {0.5, 0.9}, {0.999, 0.5}, {1e-9, 0.7}}) {
            const auto w    = sample_power_cosine(u, e);
            const auto back = invert_power_cosine(w, e);
            CHECK(std::abs(length(w) - 1) <= 1e-15);
            CHECK(std::abs(back.x - u.x) <= 1e-15 * (e + 10));
            CHECK(std::abs(back.y - u.y) <= 1e-12);
        }
        const auto last = sample_power_cosine(Vec2{1 - 0x1p-24F, 0.5F}, float(e));
        CHECK(last.z > 0);
    }
    // in float, directions near the axis keep their digits: sin^2 = 2 (1 - cos) = 2 u / (e + 1)
    const auto w = sample_power_cosine(Vec2{1e-3F, 0}, 1e4F);
    CHECK(std::abs(double(w.x) / std::sqrt(2 * 1e-3 / 1e4) - 1) <= 1e-3);
    for (const Vector2<double> u : {Vector2<double>{0.1, 0.2}, {0.5, 0.9}}) {
        const auto of_cosine = sample_cosine_hemisphere(u);
        CHECK(length(sample_power_cosine(u, 1.0) - of_cosine) <= 1e-15);
        CHECK(pdf_power_cosine(of_cosine, 1.0).value == near(pdf_cosine_hemisphere(of_cosine).value, 1e-14));
    }
}

TEST_CASE("E10: 0.6 diffuse and 0.5 Phong are more light than there is, though at 60 degrees they are not") {
    const auto refuse = [] {
        return LobeSum<double>{{{{0.6F, 0.6F, 0.6F}, Diffuse<double>{}}, {{0.5F, 0.5F, 0.5F}, Phong{20.0}}}};
    };
    CHECK_THROWS_WITH((void)refuse(),
                      "the albedo of the lobes' sum is (1.1, 1.1, 1.1); each must be from 0 to 1");
    CHECK(0.6 * 1 + 0.5 * Phong{20.0}.greatest_albedo() == near(1.1));
    CHECK(0.6 + 0.5 * 22 / (2 * pi) * phong_albedo_at(20, 60) == near(0.85025474899393885));
    CHECK(0.6 * albedo(Diffuse<double>{}, at_angle(60)) + 0.5 * albedo(Phong{20.0}, at_angle(60)) ==
          near(0.85025474899393885));
}

TEST_CASE("E11: a mirror's albedo is its reflectance at every angle") {
    const LobeSum<double> mirror{{{{0.8F, 0.8F, 0.8F}, Mirror<double>{}}}};
    for (const Direction& wo : views()) {
        const auto one = mirror.sample(wo, {0.3, 0.6}, TransportMode::radiance);
        REQUIRE(one);
        CHECK(one->weight.g == 0.8F);
        CHECK(one->wi == reflect(wo));
        CHECK(mirror.f(wo, reflect(wo)).g == 0);  // nothing to evaluate, not even there
    }
    // the limit of Phong's lobe, the factor 1 / cos put in
    CHECK((1e7 + 2) / (2 * pi) * phong_albedo_at(1e7, 45) / std::cos(radians(45)) == near(1, 1e-6));
}

TEST_CASE("E13: as it narrows, Phong's lobe loses the cosine of the angle, and a mirror does not") {
    for (const auto& [degrees, expected] : {std::pair{0.0, 1.0}, {45, 0.70710678118654752}, {60, 0.5}}) {
        CHECK((1e4 + 2) / (2 * pi) * phong_albedo_at(1e4, degrees) == near(expected));
    }
}

TEST_CASE("Phong: an impossible exponent is refused by name and value") {
    for (const double e : {-0.5, -1.0, std::nan(""), HUGE_VAL})
        CHECK_THROWS_AS(Phong<double>{e}, std::invalid_argument);
    CHECK_THROWS_WITH(Phong<double>{-0.5}, "Phong's exponent is -0.5; it must be 0 or more, such as 20");
    CHECK_NOTHROW(Phong<double>{0});
}

TEST_CASE("F3: at the critical angle total reflection begins, and Snell's window ends") {
    for (const auto& [n, critical] : {std::pair{1.5, 41.810314895778598}, {4.0 / 3, 48.590377890729141}}) {
        CAPTURE(n);
        CHECK(fresnel(std::cos(radians(critical - 1e-9)), 1 / n).mean() < 1);
        CHECK(fresnel(std::cos(radians(critical + 1e-9)), 1 / n).mean() == 1);
        CHECK(refract(at_angle(critical - 1e-9), 1 / n).has_value());
        CHECK(!refract(at_angle(critical + 1e-9), 1 / n).has_value());
    }
    // from under water the whole hemisphere above is seen in a cone of twice that angle
    const auto horizon = refract(at_angle(90 - 1e-7), 4.0 / 3);
    REQUIRE(horizon);
    CHECK(2 * degrees(std::acos(-horizon->z)) == near(97.180755781458281));
}

TEST_CASE("F4: reflectance of diffuse light, from outside and from inside") {
    for (const auto& [n, outside, inside] : {std::tuple{1.5, 0.091777959342351212, 0.59634575970771165},
                                             {4.0 / 3, 0.066458480381667611, 0.47488289521468803}}) {
        CAPTURE(n);
        CHECK(diffuse_reflectance(n, 0, 1) == near(outside));
        const double critical = std::sqrt(1 - 1 / (n * n));  // the cosine from which on light gets out
        CHECK(diffuse_reflectance(1 / n, 0, critical) + diffuse_reflectance(1 / n, critical, 1) ==
              near(inside));
        CHECK(1 - (1 - outside) / (n * n) == near(inside));
    }
}

TEST_CASE("F5: how far Schlick's approximation is off, and where") {
    for (const auto& [n, largest, at] : {std::tuple{1.5, 0.035692637507804336, 84.974575443226496},
                                         {1.333, 0.05917807109249359, 83.811117349318385},
                                         {2.42, 0.075691223423302909, 84.51244591256752}}) {
        CAPTURE(n);
        double worst = 0, where = 0;
        for (double angle = 0; angle < 90; angle += 1e-4) {
            const double c     = std::cos(radians(angle));
            const double error = std::abs(schlick(c, n) - fresnel(c, n).mean());
            if (error > worst) {
                worst = error;
                where = angle;
            }
        }
        CHECK(worst == near(largest, 1e-9));
        CHECK(std::abs(where - at) <= 1e-4);
    }
}

TEST_CASE("F6: a cone of light is compressed where it is refracted, by as much as its radiance grows") {
    const double n = 1.5, cos_i = 0.5, h = 1e-6;
    const auto   cos_t = [&](double c) {
        return -refract(Direction{std::sqrt((1 - c) * (1 + c)), 0, c}, n)->z;
    };
    // the azimuth is kept, and d omega = d(cos) d(phi)
    const double ratio = (cos_t(cos_i + h) - cos_t(cos_i - h)) / (2 * h);
    CHECK(ratio == near(0.27216552697590868, 1e-9));
    CHECK(cos_i / (n * n * cos_t(cos_i)) == near(0.27216552697590868));
}

TEST_CASE("F11: a metal like gold reflects most, and least where a dielectric lets all through") {
    const std::complex index{0.2, 3.0};
    CHECK(fresnel(1.0, index).mean() == near(0.92337164750957854));
    CHECK(fresnel(std::cos(radians(60)), index).mean() == near(0.9184110846593691));
    for (double c = 0; c <= 1; c += 0.01) {  // without absorption it is glass
        const auto glass = fresnel(c, 1.5), metal = fresnel(c, std::complex{1.5, 0.0});
        CHECK(std::abs(glass.s - metal.s) <= 1e-14);
        CHECK(std::abs(glass.p - metal.p) <= 1e-14);
    }
}

TEST_CASE("H1, H2, H3: moments of the hemisphere's samplers, and what each makes of a power of the cosine") {
    Rng                    rng{72, 0, 0, 0};
    constexpr int          draws = 200'000;
    Running                of_uniform, of_cosine, light_uniform, light_cosine;
    std::array             powers{2.0, 3.0, 5.0, 10.0, 50.0};
    std::array<Running, 5> uniform, cosine;
    for (int i = 0; i < draws; ++i) {
        const double u = rng.uniform<double>(), v = rng.uniform<double>();
        const double z = sample_uniform_hemisphere(Vector2<double>{u, v}).z,
                     c = sample_cosine_hemisphere(Vector2<double>{u, v}).z;
        of_uniform.add(z);
        of_cosine.add(c);
        light_uniform.add(2 * pi * z);
        light_cosine.add(c / pdf_cosine_hemisphere(Direction{0, 0, c}).value);
        for (std::size_t k = 0; k < powers.size(); ++k) {
            uniform[k].add(2 * pi * std::pow(z, powers[k]));
            cosine[k].add(pi * std::pow(c, powers[k] - 1));
        }
    }
    const auto holds = [](const Running& of, double mean) {
        return std::abs(of.mean() - mean) <= 5 * of.standard_error();
    };
    CHECK(holds(of_uniform, 0.5));
    CHECK(holds(of_cosine, 0.66666666666666667));
    CHECK(!holds(of_cosine, 0.66));
    CHECK(of_uniform.variance() == near(0.083333333333333333, 0.02));
    CHECK(of_cosine.variance() == near(0.055555555555555556, 0.02));
    CHECK(holds(light_uniform, 3.1415926535897932));
    CHECK(light_uniform.variance() == near(3.2898681336964529, 0.02));
    CHECK(light_cosine.mean() == near(3.1415926535897932));
    CHECK(light_cosine.variance() <= 1e-24);
    const std::array known_uniform{3.5091926759428831, 3.1723728432072938, 2.492324343709434,
                                   1.5536567337409459, 0.37569725281172735};
    const std::array known_cosine{0.54831135561607548, 0.82246703342411322, 0.87729816898572077,
                                  0.66069252602333723, 0.18221391900819339};
    for (std::size_t k = 0; k < powers.size(); ++k) {
        CAPTURE(powers[k]);
        CHECK(holds(uniform[k], 2 * pi / (powers[k] + 1)));
        CHECK(holds(cosine[k], 2 * pi / (powers[k] + 1)));
        CHECK(uniform[k].variance() == near(known_uniform[k], 0.05));
        CHECK(cosine[k].variance() == near(known_cosine[k], 0.05));
    }
}

TEST_CASE("checker: squares of side 1 in turn, on both sides of 0") {
    const Checker board{{1, 1, 1}, {0.25F, 0.5F, 0}};
    CHECK(board(Vec2{0.5F, 0.5F}) == board.even);
    CHECK(board(Vec2{1.5F, 0.5F}) == board.odd);
    CHECK(board(Vec2{1.5F, 1.5F}) == board.even);
    CHECK(board(Vec2{-0.5F, 0.5F}) == board.odd);
    CHECK(board(Vec2{-0.5F, -0.5F}) == board.even);
    CHECK(board(Vec2{1e6F, 0.5F}) == board.even);
}
