/// @file material_laws.cpp
/// Every lobe keeps the laws, and each law finds a lobe that breaks it.

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "bsdf_laws.hpp"
#include "delta_laws.hpp"
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

/// Of two lobes the brighter one: light that disturbs light.
struct Brighter : Diffuse<double> {
    [[nodiscard]] double f(const V& wo, const V& wi) const {
        return std::max(0.5 * Diffuse<double>::f(wo, wi), 0.4 * Phong{30.0}.f(wo, wi));
    }
};

/// A right sum that is drawn by its first part alone.
struct FirstPartOnly : LobeSum<double> {
    [[nodiscard]] Sample sample(const V& wo, Vector2<double> u, TransportMode mode) const {
        return Diffuse<double>{}.sample(wo, u, mode);
    }
};

/// Glass that forgets to count a way the more, the less often it draws it.
struct OftenOnly : Dielectric<double> {
    [[nodiscard]] Sample sample(const V& wo, Vector2<double> u, TransportMode mode) const {
        const auto both = branches(wo, mode);
        return u.x < both.reflected.weight ? both.reflected : *both.refracted;
    }
};

/// A mirror that turns light about its normal, and makes some.
struct BrightTurned {
    [[nodiscard]] Sample sample(const V& wo, Vector2<double>, TransportMode) const {
        if (!(wo.z > 0)) return std::nullopt;
        return BsdfSample<double>{{-wo.y, wo.x, wo.z}, 1.01, {}, true};
    }
};

}  // namespace

TEST_CASE("laws: diffuse and Phong's lobes keep all of them") {
    CHECK(broken_laws(Diffuse<double>{}) == "");
    CHECK(breaks_jacobian(Diffuse<double>{}) == "");
    for (const double e : {0.0, 1.0, 2.5, 10.0, 50.0}) {
        CAPTURE(e);
        for (const PhongScale scale : {PhongScale::density, PhongScale::albedo}) {
            CHECK(broken_laws(Phong{e, scale}) == "");
            CHECK(breaks_jacobian(Phong{e, scale}) == "");
        }
    }
    CHECK(broken_laws(Phong{20.0, PhongScale::none}) == "");
}

TEST_CASE("laws: a sum of lobes keeps them as its parts do, and is linear") {
    const Spectrum        half{0.5F, 0.5F, 0.5F}, quarter{0.25F, 0.25F, 0.25F};
    const Phong           glossy{30.0};
    const LobeSum<double> plastic{{{half, Diffuse<double>{}}, {quarter, glossy}}};
    CHECK(broken_laws(plastic) == "");
    CHECK(breaks_linearity(plastic, 0.5, Diffuse<double>{}, 0.25, glossy) == "");
    const LobeSum<double> varnish{{{quarter, glossy}, {half, Mirror<double>{}}}};
    CHECK(breaks_linearity(varnish, 0.25, glossy, 0.5, Mirror<double>{}) == "");

    CHECK(breaks_linearity(plastic, 0.5, Diffuse<double>{}, 0.26, glossy) != "");
    CHECK(breaks_linearity(varnish, 0.25, glossy, 0.6, Mirror<double>{}) != "");
    CHECK(breaks_linearity(Brighter{}, 0.5, Diffuse<double>{}, 0.4, glossy) != "");
    CHECK(breaks_linearity(FirstPartOnly{plastic}, 0.5, Diffuse<double>{}, 0.25, glossy) != "");
}

TEST_CASE("laws: each finds the lobes that break it, and no others") {
    CHECK(broken_laws(Unclamped{{}, 2}) == "positivity energy ");  // light from behind the lobe
    CHECK(broken_laws(Unclamped{{}, 3}) == "positivity energy ");
    CHECK(broken_laws(Unclamped{{}, 2.5}) == "positivity reciprocity energy ");  // NaN, either way
    CHECK(broken_laws(BelowTheHorizon{}) == "positivity reciprocity energy normalisation ");
    CHECK(broken_laws(OneWay{}) == "reciprocity ");
    CHECK(broken_laws(Phong{1.0, PhongScale::none}) == "energy ");
    CHECK(broken_laws(ExtraCosine{}) == "energy ");
    CHECK(broken_laws(Doubled{}) == "normalisation ");
    CHECK(broken_laws(MissingCosine{}) == "density ");
    CHECK(broken_laws(HalfTurn{}) == "density ");

    CHECK(breaks_jacobian(MissingCosine{}) != "");
    CHECK(breaks_jacobian(HalfTurn{}) != "");
    CHECK(breaks_jacobian(Doubled{}) != "");
    CHECK(breaks_jacobian(ExtraCosine{}) == "");
}

TEST_CASE("laws: the chi-square test tells a lobe from one a little wider") {
    CHECK(chance_of_density(Phong{20.0}, Phong{20.0}) > 0.001);
    CHECK(chance_of_density(Phong{20.0}, Phong{19.0}) < 1e-6);
}

TEST_CASE("laws of deltas: what is seen one way is seen the other, and nothing is gained") {
    CHECK(breaks_delta_energy(Mirror<double>{}) == "");
    CHECK(breaks_delta_reciprocity(Mirror<double>{}) == "");
    CHECK(ways(Mirror<double>{}, at_angle(50), TransportMode::radiance).size() == 1);
    CHECK(ways(Mirror<double>{}, -at_angle(50), TransportMode::radiance).empty());
    for (const double n : {1 / 1.5, 4.0 / 3, 1.5, 2.42}) {
        CAPTURE(n);
        CHECK(breaks_delta_energy(Dielectric{n}) == "");
        CHECK(breaks_delta_reciprocity(Dielectric{n}) == "");
    }
    CHECK(breaks_delta_energy(OftenOnly{Dielectric{1.5}}) != "");
    CHECK(breaks_delta_energy(BrightTurned{}) != "");
    CHECK(breaks_delta_reciprocity(BrightTurned{}) != "");
}

TEST_CASE("dielectric: what is not reflected goes through, the n^2 taken out") {
    for (const V& wo : views()) {
        for (const double n : {4.0 / 3, 1.5, 2.42}) {
            CAPTURE(n);
            const auto out = Dielectric{n}.branches(wo, TransportMode::radiance);
            REQUIRE(out.refracted);
            CHECK(std::abs(out.reflected.weight + out.refracted->weight * n * n - 1) <= 1e-14);
        }
    }
}
