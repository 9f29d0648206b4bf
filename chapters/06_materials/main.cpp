/// @file main.cpp
/// Chapter 6, materials: what a surface does with the light that arrives.

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <string>
#include <tuple>
#include <vector>

#include "albedo_race.hpp"
#include "border_chart.hpp"
#include "course/chapter.hpp"
#include "course/claims.hpp"
#include "diagrams.hpp"
#include "experiments.hpp"
#include "furnace.hpp"
#include "grazing_chart.hpp"
#include "lobe_surfaces.hpp"
#include "skies.hpp"
#include "spheres.hpp"
#include "step_sky_chart.hpp"
#include "transparent.hpp"

namespace sr {
namespace {

constexpr double pi = std::numbers::pi;

/// 6.1  How much of the light that arrives leaves, and where to?
void definition(course::Chapter& chapter) {
    chapter.section("6.1 From light to light");
    auto diagram = chapter.diagram("definition", "Light that arrives, and light that leaves");
    draw_definition(diagram);
    diagram.caption("The BRDF is the radiance that leaves over the irradiance that caused it, [1/sr].");
    const Vector3<double> n{0, 0, 1};
    const course::Claims  claim{chapter, "6.1"};
    claim("f of a diffuse surface of 0.8 [1/sr]", 0.255, 0.8 * Diffuse<double>{}.f(n, n), 0.0005);
    claim("largest f of the lobe of exponent 1000 [1/sr]", 159.5, Phong{1000.0}.f(n, n), 0.05);
}

/// 6.2  What leaves a surface under a whole sky?
void under_skies(course::Chapter& chapter) {
    chapter.section("6.2 The reflectance equation, applied");
    const HemisphereRule rule = hemisphere_rule(128);
    const course::Claims claim{chapter, "6.2"};
    const auto           wo = at_angle(-50);
    const auto table = [&](const std::string& name, const auto& sky, const std::vector<double>& printed) {
        const double E = irradiance(sky, rule), diffuse = 0.8 * reflected(Diffuse<double>{}, sky, wo, rule);
        const double glossy = 0.8 * reflected(Phong{20.0}, sky, wo, rule);
        claim(name + ": irradiance [sr L]", printed[0], E, 0.0005);
        claim(name + ": from diffuse", printed[1], diffuse, 0.0005);
        claim(name + ": the same over the irradiance [1/sr]", 0.2546, diffuse / E, 0.00005);
        claim(name + ": from Phong's lobe", printed[2], glossy, 0.0005);
        claim(name + ": the same over the irradiance [1/sr]", printed[3], glossy / E, 0.0005);
        claim(name + ": from a mirror", printed[4], 0.8 * reflected(Mirror<double>{}, sky, wo, rule), 0.0005);
    };
    table("uniform", UniformSky{}, {3.142, 0.8, 0.514, 0.164, 0.8});
    table("step", StepSky{}, {1.571, 0.4, 0.514, 0.327, 0.8});
    table("clear", ClearSky{at_angle(45)}, {4.849, 1.235, 2.195, 0.453, 4.979});
    chart_step_sky(chapter, rule);
}

/// 6.3  What must every BRDF keep?
void four_laws(course::Chapter& chapter) {
    chapter.section("6.3 Four laws");
    auto diagram = chapter.diagram("unclamped", "Phong's lobe without a clamp");
    draw_unclamped(diagram);
    diagram.caption(
        "The power of a negative cosine is light from behind the lobe, negative light, or no number.");
    constexpr int        pairs = 1'000'000;
    const course::Claims claim{chapter, "6.3"};
    for (const double e : {2.0, 3.0, 2.5})
        claim(fmt::format("unclamped, exponent {}: pairs that are wrong [%]", e), 32,
              percent_wrong_behind(e, pairs), 0.5);

    const HemisphereRule rule = hemisphere_rule(96);
    claim("Phong: worst difference of f both ways", 0, worst_reciprocity(Phong{20.0}, pairs), 0);
    claim("diffuse: largest albedo", 1, largest_albedo(Diffuse<double>{}, rule), 1e-12);
    claim("Phong as it is, exponent 1: largest albedo", 2.09,
          largest_albedo(Phong{1.0, PhongScale::none}, rule), 0.005);
    const auto [of_sum, sum_of] = linearity(rule);
    claim("what leaves a sum of lobes under the clear sky", 1.323, of_sum, 0.0005);
    chapter.claim_at_most("6.3 that less the sum of what leaves each, relative",
                          std::abs(of_sum / sum_of - 1), 1e-6);
}

/// 6.4  Which lobes are there?
void lobes(course::Chapter& chapter) {
    chapter.section("6.4 Diffuse, mirror, and what lies between");
    auto diagram = chapter.diagram("lobes", "Lobes in the plane of incidence");
    draw_lobes(diagram);
    diagram.caption("The distance from the lit point is f, in every direction.");
    portray_lobes(chapter);
    const course::Claims claim{chapter, "6.4"};
    const auto           one = Mirror<double>{}.sample(at_angle(89.999), {0.5, 0.5}, TransportMode::radiance);
    claim("a mirror of 0.8, sampled near 90 degrees", 0.8, one ? 0.8 * one->weight : 0, 0);
    const auto wo = at_angle(-50);
    claim("f of the diffuse lobe [1/sr]", 0.318, Diffuse<double>{}.f(wo, at_angle(50)), 0.0005);
    claim("f of exponent 20 along r [1/sr]", 3.5, Phong{20.0}.f(wo, at_angle(50)), 0.05);
}

/// 6.5  For which exponents does the textbook's lobe make light?
void border(course::Chapter& chapter) {
    chapter.section("6.5 Where Phong's lobe makes light");
    chart_border(chapter);
    const HemisphereRule rule = hemisphere_rule(64);
    const course::Claims claim{chapter, "6.5"};
    const auto normal = [&](double e) { return albedo(Phong(e, PhongScale::none), {0, 0, 1}, rule); };
    const auto limit  = [&](double rho) {
        const auto excess = [&](double e) { return rho * normal(e) - 1; };
        return bracketed_root(excess, Interval<double>{0, 6}).value();
    };
    claim("exponent from which on a reflectance of 1 is possible", 4.283, limit(1), 0.0005);
    claim("the same for a reflectance of 0.5", 1.142, limit(0.5), 0.0005);
    claim("albedo for an exponent of 1", 2.094, normal(1), 0.0005);
    claim("largest reflectance for an exponent of 1", 0.477, 1 / normal(1), 0.0005);
    claim("albedo for an exponent of 100", 0.062, normal(100), 0.0005);
    claim("albedo for an exponent of 1000", 0.0063, normal(1000), 0.00005);
}

/// 6.6  What do the cures break?
void cures(course::Chapter& chapter) {
    chapter.section("6.6 Two scales, two divisions, and the horizon");
    const HemisphereRule  rule  = hemisphere_rule(128);
    const auto            chart = chart_grazing(chapter, rule);
    const DividedByCosine over_cosine{Phong{10.0, PhongScale::density}};
    const DividedByLarger over_larger{Phong{10.0}};
    render_furnace(chapter);

    const course::Claims claim{chapter, "6.6"};
    claim("(e + 1): albedo at normal incidence", 0.917, chart.at("$(e+1)/2\\pi$", 0), 0.0005);
    claim("(e + 2): albedo at 45 degrees", 0.707, chart.at("$(e+2)/2\\pi$", 45), 0.0005);
    claim("(e + 2): albedo at 75 degrees", 0.292, chart.at("$(e+2)/2\\pi$", 75), 0.0005);
    claim("(e + 2): albedo at 90 degrees", 0.123, 12 / (2 * pi) * phong_albedo(10, pi / 2), 0.0005);
    claim("(e + 2), exponent 10 000: albedo at 60 degrees", 0.5, chart.at("$(e+2)/2\\pi$, $e = 10^4$", 60),
          0.0005);
    claim("over the cosine: albedo at 75 degrees", 0.803, chart.at("over $\\cos\\theta_i$", 75), 0.0005);
    claim("share of the lobe below the horizon at 75 degrees", 0.197,
          1 - albedo(over_cosine, at_angle(75), rule), 0.0005);
    claim("over the larger cosine: albedo at 75 degrees", 0.713, chart.at("over the larger cosine", 75),
          0.0005);
    claim("over the larger cosine: largest albedo", 1, largest_albedo(over_larger, rule), 1e-9);
    claim("over the larger cosine: worst difference of f both ways", 0,
          worst_reciprocity(over_larger, 100'000), 0);
    claim("over the larger cosine, exponent 0: albedo at 46 degrees", 1.09,
          albedo(DividedByLarger{Phong{0.0}}, at_angle(46), rule), 0.005);
    const double cosine = over_cosine.f(at_angle(60), at_angle(0)) / over_cosine.f(at_angle(0), at_angle(60));
    claim("over the cosine: f from 0 to 60 degrees over f back", 0.5, cosine, 1e-12);
    const double ks = 0.5 * 22 / (2 * pi);
    claim("lobes of 0.6 and 0.5: albedo at normal incidence", 1.1, 0.6 + ks * phong_albedo(20, 0), 0.0005);
    claim("lobes of 0.6 and 0.5: albedo at 60 degrees", 0.85, 0.6 + ks * phong_albedo(20, radians(60)),
          0.0005);
}

/// What the text says of one race: the power by which each way's error falls, and its error.
void claim_powers(course::Chapter& chapter, const std::string& race, const std::vector<AlbedoLap>& laps,
                  const std::vector<std::string>& ways) {
    const course::Claims claim{chapter, "6.7"};
    course::Rows         powers{{"race", "way", "power by which the error falls", "standard error"}};
    for (const std::string& way : ways) {
        const auto [power, error] = slope_of(laps, way);
        powers.add({race, way, -power, error});
        claim(fmt::format("{}, {}: power by which the error falls", race, way), 0.5, -power, 0.05);
        chapter.claim_at_most(fmt::format("6.7 {}, {}: that less one half [its standard errors]", race, way),
                              std::abs(power + 0.5) / error, 3);
    }
    course::Rows errors{{"race", "way", "directions", "error", "standard error"}};
    for (const auto& lap : laps)
        errors.add({race, lap.name, lap.effort, lap.error,
                    lap.error_se > 0 ? course::Cell(lap.error_se) : course::Cell("-")});
    chapter.say(errors);
    chapter.say(powers);
}

/// 6.7  What does an albedo cost?
void albedo_against_time(course::Chapter& chapter) {
    chapter.section("6.7 An albedo, its error against time");
    const course::Claims claim{chapter, "6.7"};
    const auto&          options = chapter.options();
    std::uint64_t        curve   = 1;
    for (const auto& [name, e, finest] : {std::tuple{"wide", 10.0, 25}, {"narrow", 1000.0, 107}}) {
        const auto laps  = race_phong(e, finest, curve, options.threads);
        auto       chart = chapter.chart(fmt::format("albedo_{}", name),
                                         fmt::format("Albedo of Phong's lobe, $e = {}$, seen from 45 degrees", e),
                                         albedo_axes());
        chart_albedo(chart, laps, options.quality);
        chart.caption(
            e < 100 ? "Drawn by the lobe, directions count alike but for a cosine; quadrature needs few."
                    : "Other ways rarely draw where the lobe is; nor has quadrature a point there, until "
                      "it has thousands.");
        claim_powers(chapter, name, laps, {"uniform", "cosine", "lobe"});
        const double gained = lap_of(laps, "uniform", 16).error / lap_of(laps, "lobe", 16).error;
        claim(fmt::format("{}: error, uniform over lobe", name), e < 100 ? 7.6 : 700, gained,
              e < 100 ? 0.05 : 50);
        chapter.claim_at_most(
            fmt::format("6.7 {}: error of quadrature, {} directions", name, laps.back().effort),
            laps.back().error, 1e-13);
        curve += 3;
    }
    const auto others = race_others(curve, options.threads);
    auto       chart  = chapter.chart("albedo_others", "Albedos of diffuse and of glass", albedo_axes());
    chart_albedo(chart, others, options.quality);
    chart.caption("All else that the lobes of this chapter allow has no error to chart.");
    claim_powers(chapter, "others", others, {"diffuse, uniform", "glass, one way"});
    const HemisphereRule coarse = hemisphere_rule(3);
    claim("diffuse: quadrature with 18 directions", 1, albedo(Diffuse<double>{}, at_angle(45), coarse),
          1e-12);
}

/// 6.10  All of them.
void materials(course::Chapter& chapter) {
    chapter.section("6.10 A sphere of each");
    render_spheres(chapter);
}

}  // namespace
}  // namespace sr

int main(int argc, char** argv) {
    using namespace sr;
    const course::Defaults defaults{
        .samples        = course::ByQuality{.draft = 16, .lecture = 256, .print = 1024},
        .square_samples = true,
        .sampled_each   = "pixel of the spheres, 6.10; other pictures have their own number",
        .seeded         = "the spheres, 6.10; what the text quotes has its own"};
    return course::run(argc, argv, "06_materials", "Materials", defaults, [](course::Chapter& chapter) {
        definition(chapter);
        under_skies(chapter);
        four_laws(chapter);
        lobes(chapter);
        border(chapter);
        cures(chapter);
        albedo_against_time(chapter);
        transparent(chapter);
        radiance_in_glass(chapter);
        materials(chapter);
    });
}
