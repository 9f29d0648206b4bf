/// @file material_laws.cpp
/// Every lobe keeps the laws, and each law finds a lobe that breaks it.

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

#include "bsdf_laws.hpp"
#include "material/lobe_sum.hpp"

using namespace sr;
using namespace sr::test;

namespace {

using V      = Direction;
using Sample = std::optional<BsdfSample<double>>;
using Angles = Pdf<measure::SolidAngle>;

/// Draws by the cosine and says that it drew uniformly: the cosine is missing in the pdf.
struct MissingCosine : Diffuse<double> {
    [[nodiscard]] Angles pdf(const V& wo, const V& wi) const {
        return wo.z > 0 ? pdf_uniform_hemisphere(wi) : Angles{};
    }
    [[nodiscard]] Sample sample(const V& wo, Vector2<double> u, TransportMode mode) const {
        auto one = Diffuse<double>::sample(wo, u, mode);
        if (one) one->pdf = pdf(wo, one->wi);
        return one;
    }
};

/// Phong's lobe as it comes, also from below the horizon.
struct BelowTheHorizon {
    [[nodiscard]] double f(const V& wo, const V& wi) const {
        const double cosine = dot(reflect(wo), wi);
        return wo.z > 0 && cosine > 0 ? 12 / (2 * std::numbers::pi) * std::pow(cosine, 10) : 0;
    }
    [[nodiscard]] Angles pdf(const V& wo, const V& wi) const {
        return wo.z > 0 ? pdf_power_cosine(frame_around(reflect(wo)).to_local(wi), 10.0) : Angles{};
    }
    [[nodiscard]] Sample sample(const V& wo, Vector2<double> u, TransportMode) const {
        const V wi = frame_around(reflect(wo)).to_world(sample_power_cosine(u, 10.0));
        return BsdfSample<double>{wi, 12.0 / 11 * wi.z, pdf(wo, wi)};
    }
};

/// Darker at grazing incidence, not at grazing exitance; its albedo is 1 everywhere.
struct OneWay : Diffuse<double> {
    [[nodiscard]] double f(const V& wo, const V& wi) const { return 1.5 * wi.z * Diffuse<double>::f(wo, wi); }
};

/// Phong's lobe as Phong wrote it, without a clamp.
struct Unclamped : Diffuse<double> {
    double               e;
    [[nodiscard]] double f(const V& wo, const V& wi) const { return std::pow(dot(reflect(wo), wi), e); }
};

/// Counts the cosine twice where it is sampled.
struct ExtraCosine : Diffuse<double> {
    [[nodiscard]] Sample sample(const V& wo, Vector2<double> u, TransportMode mode) const {
        auto one = Diffuse<double>::sample(wo, u, mode);
        if (one) one->weight *= one->wi.z;
        return one;
    }
};

/// Draws on half of the hemisphere only, with a density that is right there.
struct HalfTurn : Diffuse<double> {
    [[nodiscard]] Sample sample(const V& wo, Vector2<double> u, TransportMode mode) const {
        return Diffuse<double>::sample(wo, {u.x, u.y / 2}, mode);
    }
};

/// States a density twice as large as it is.
struct Doubled : Diffuse<double> {
    [[nodiscard]] Angles pdf(const V& wo, const V& wi) const {
        return {2 * Diffuse<double>::pdf(wo, wi).value};
    }
};

}  // namespace

TEST_CASE("laws: diffuse and Phong's lobes keep all of them") {
    CHECK(breaks_a_law(Diffuse<double>{}) == "");
    CHECK(breaks_jacobian(Diffuse<double>{}) == "");
    for (const double e : {0.0, 1.0, 2.5, 10.0, 50.0}) {
        CAPTURE(e);
        for (const PhongScale scale : {PhongScale::density, PhongScale::albedo}) {
            CHECK(breaks_a_law(Phong{e, scale}) == "");
            CHECK(breaks_jacobian(Phong{e, scale}) == "");
        }
    }
    CHECK(breaks_a_law(Phong{20.0, PhongScale::none}) == "");
}

TEST_CASE("laws: a sum of lobes keeps them as its parts do") {
    const LobeSum<double> plastic{
        {{{0.5F, 0.3F, 0.1F}, Diffuse<double>{}}, {{0.4F, 0.4F, 0.4F}, Phong{30.0}}}};
    CHECK(breaks_a_law(plastic) == "");
}

TEST_CASE("laws: each finds a lobe that breaks it, and only the right ones do") {
    CHECK(breaks_positivity(Unclamped{{}, 2.5}) != "");
    CHECK(breaks_positivity(Unclamped{{}, 3}) != "");
    CHECK(breaks_positivity(Unclamped{{}, 2}) != "");  // light from behind the lobe
    CHECK(breaks_positivity(BelowTheHorizon{}) != "");
    CHECK(breaks_reciprocity(OneWay{}) != "");
    CHECK(breaks_energy(Phong{1.0, PhongScale::none}) != "");
    CHECK(breaks_energy(ExtraCosine{}) != "");
    CHECK(breaks_normalisation(Doubled{}) != "");
    CHECK(breaks_density(MissingCosine{}) != "");
    CHECK(breaks_jacobian(MissingCosine{}) != "");
    CHECK(breaks_density(BelowTheHorizon{}) != "");
    CHECK(breaks_density(HalfTurn{}) != "");
    CHECK(breaks_jacobian(HalfTurn{}) != "");

    CHECK(breaks_energy(OneWay{}) == "");
    CHECK(breaks_reciprocity(MissingCosine{}) == "");
    CHECK(breaks_normalisation(MissingCosine{}) == "");
    CHECK(breaks_reciprocity(BelowTheHorizon{}) != "");  // seen from below, it is dark
}

TEST_CASE("laws: the chi-square test tells a lobe from one a little wider") {
    CHECK(chance_of_density(Phong{20.0}, Phong{20.0}) > 0.001);
    CHECK(chance_of_density(Phong{20.0}, Phong{19.0}) < 1e-6);
}

TEST_CASE("laws of deltas: what is seen one way is seen the other, and nothing is gained") {
    for (const V& wo : views()) {
        const auto one = Mirror<double>{}.sample(wo, {0.5, 0.5}, TransportMode::radiance);
        REQUIRE(one);
        CHECK((one->is_delta && one->weight == 1 && one->pdf.value == 0));
        CHECK(Mirror<double>{}.sample(one->wi, {0.5, 0.5}, TransportMode::radiance)->wi == wo);
        CHECK(!Mirror<double>{}.sample(-wo, {0.5, 0.5}, TransportMode::radiance));

        for (const double n : {4.0 / 3, 1.5, 2.42}) {
            CAPTURE(n);
            const Dielectric surface{n};
            const auto       out = surface.branches(wo, TransportMode::radiance);
            REQUIRE(out.refracted);
            // the n^2 taken out, all that is not reflected goes through, both ways the same
            CHECK(std::abs(out.reflected.weight + out.refracted->weight * n * n - 1) <= 1e-14);
            const auto back = surface.branches(out.refracted->wi, TransportMode::radiance);
            REQUIRE(back.refracted);
            CHECK(length(back.refracted->wi - wo) <= 1e-12);
            CHECK(std::abs(out.refracted->weight * n * n / (back.refracted->weight / (n * n)) - 1) <= 1e-12);
            CHECK(std::abs(back.reflected.weight / out.reflected.weight - 1) <= 1e-12);
        }
    }
}
