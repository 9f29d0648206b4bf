#pragma once
/// @file hemisphere_charts.hpp
/// What section 9.2 charts: variances against how narrow the integrand is, and directions drawn by two densities.

#include <fmt/format.h>

#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <tuple>

#include "course/chapter.hpp"
#include "course/claims.hpp"
#include "course/curves.hpp"
#include "hemisphere_variances.hpp"
#include "math/bracketed_root.hpp"
#include "math/degrees.hpp"
#include "math/extremes.hpp"

namespace sr {

/// Directions on the hemisphere, seen from the side, and below that from above.
template <class Directions>
void draw_directions(course::Diagram diagram, double left, const std::string& name, course::Ink ink,
                     const Directions& p) {
    using course::Point;
    const Point from_side{left, 1.2}, from_above{left, 0};
    diagram.polygon(course::arc(from_side, 1, 0, 180), {course::Ink::grey, course::Weight::thin}, 0.1);
    diagram.polygon(course::arc(from_above, 1), {course::Ink::grey, course::Weight::thin}, 0.1);
    Rng rng{96, 0, 0, 0};
    for (int i = 0; i < 100; ++i) {
        const auto w = p.sample(draw_pair(rng));
        diagram.point(from_side + Point{w.x, w.z}, {ink});
        diagram.point(from_above + Point{w.x, w.y}, {ink});
    }
    diagram.label({left, -1.15}, name, course::Anchor::centre, ink);
}

/// How far a measured variance lies from what it should be, in its standard errors.
[[nodiscard]] inline double deviation(Estimate measured, double exact) {
    return std::abs(measured.value - exact) / measured.error;
}

/// Figure 9.3, and the mean height of such directions.
inline void show_directions(course::Chapter& chapter) {
    auto diagram = chapter.diagram("directions",
                                   "100 directions by each of two densities, from the side and from above");
    draw_directions(diagram, 0, "$p = 1/2\\pi$", course::Ink::blue, UniformDirections{});
    draw_directions(diagram, 2.4, "$p = \\cos\\theta/\\pi$", course::Ink::vermilion, CosineDirections{});
    diagram.caption("By the cosine, directions are uniform as seen from above, on the disk below them.");
    const auto height = [&](std::uint64_t stream, const auto& p) {
        const auto z = [&](const Vector3<double>& w) { return w.z * p.pdf(w); };
        return moments_over_hemisphere(z, p, stream, chapter.options().threads).mean;
    };
    const Estimate uniform = height(9201, UniformDirections{}), cosine = height(9202, CosineDirections{});
    const course::Claims claim{chapter, "9.2"};
    claim("mean cosine of 262 144, uniform", 0.5009, uniform.value, 5e-5);
    claim("its standard error", 0.0006, uniform.error, 5e-5);
    claim("mean cosine of 262 144, by the cosine", 0.6665, cosine.value, 5e-5);
    claim("its standard error", 0.0005, cosine.error, 5e-5);
    chapter.claim_at_most("9.2 mean cosines off [their standard errors]",
                          max_or_nan(deviation(uniform, 0.5), deviation(cosine, 2.0 / 3)), 4);
}

/// Adds a density's exact variances as a line, of cos^e, and what is measured as dots.
template <class Directions>
void add_powers(course::Chapter& chapter, course::Chart chart, const std::string& name, std::uint64_t stream,
                const Directions& p) {
    for (double e = 1; e < 51; e *= std::pow(50, 1.0 / 32)) chart.add(name, e, {power_variance(p, e), 0});
    chart.as_line(name);
    double worst = 0;
    for (const double e : {1.0, 2.0, 3.0, 5.0, 10.0, 20.0, 50.0}) {
        const auto power = [=](const Vector3<double>& w) { return std::pow(w.z, e); };
        const auto found =
            moments_over_hemisphere(power, p, stream + std::uint64_t(e), chapter.options().threads);
        chart.add("measured", e, found.variance);
        const double exact = power_variance(p, e);
        if (exact > 0)
            worst = max_or_nan(worst, deviation(found.variance, exact));
        else
            chapter.claim_at_most(fmt::format("9.2 {}: variance for the exponent {}", name, e),
                                  found.variance.value, 1e-24);
    }
    chapter.claim_at_most(fmt::format("9.2 {}: powers' variances off [their standard errors]", name), worst,
                          4);
}

/// Figure 9.4: variances for cos^e.
inline void chart_powers(course::Chapter& chapter) {
    auto chart = chapter.chart(
        "power_variance", "The integral of $\\cos^e\\theta$ over the hemisphere",
        course::with_error({.x = "exponent $e$", .y = "variance of one sample", .log = course::axis::x}));
    add_powers(chapter, chart, "uniform", 92100, UniformDirections{});
    add_powers(chapter, chart, "by the cosine", 92200, CosineDirections{});
    chart.as_points("measured");
    chart.in_ink("measured", course::Ink::black);
    chart.in_ink("by the cosine", course::Ink::vermilion);
    chart.caption(
        "Lines: exactly. Dots: of 262 144 samples; their standard errors are smaller than they are.");
    const course::Claims claim{chapter, "9.2"};
    for (const auto& [e, uniform, cosine] :
         {std::tuple{1.0, 3.290, 0.0}, {2.0, 3.509, 0.548}, {5.0, 2.492, 0.877}, {50.0, 0.376, 0.182}}) {
        claim(fmt::format("exponent {}: variance, uniform", e), uniform,
              power_variance(UniformDirections{}, e), 0.0005);
        claim(fmt::format("exponent {}: variance, by the cosine", e), cosine,
              power_variance(CosineDirections{}, e), 0.0005);
    }
}

/// So many samples have a standard error of 1 % of the cap's irradiance, at that variance of one.
[[nodiscard]] inline double needed(const CapLight& cap, double variance) {
    return variance / square(0.01 * cap.irradiance());
}

[[nodiscard]] inline CapLight cap_of(double degrees) {
    return {std::sin(radians(degrees))};
}

/// Adds what a density needs for caps of all sizes, exactly and measured.
/// @param density  (cap) -> directions
template <class Density>
void add_caps(course::Chapter& chapter, course::Chart chart, const std::string& name, std::uint64_t stream,
              const Density& density) {
    for (double angle = 1; angle < 80.1; angle *= std::pow(80, 1.0 / 64)) {
        const CapLight cap = cap_of(angle);
        chart.add(name, angle, {needed(cap, cap_variance(density(cap), cap)), 0});
    }
    chart.as_line(name);
    double worst = 0;
    for (const double angle : {2.0, 5.0, 10.0, 20.0, 30.0, 45.0, 60.0, 80.0}) {
        const CapLight cap   = cap_of(angle);
        const auto     found = moments_over_hemisphere(cap, density(cap), stream + std::uint64_t(angle),
                                                       chapter.options().threads)
                               .variance;
        chart.add("measured", angle, {needed(cap, found.value), needed(cap, found.error)});
        worst = max_or_nan(worst, deviation(found, cap_variance(density(cap), cap)));
    }
    chapter.claim_at_most(fmt::format("9.2 {}: caps' variances off [their standard errors]", name), worst, 4);
}

/// The half-angle of the cap for which both are as good, the cosine and its own cone [deg].
[[nodiscard]] inline std::optional<double> even_caps() {
    const auto advantage = [](double angle) {
        const CapLight cap = cap_of(angle);
        return cap_variance(CosineDirections{}, cap) - cap_variance(ConeDirections{cap.sine}, cap);
    };
    return bracketed_root(advantage, Interval<double>{45, 89});
}

/// Figure 9.5: samples for an error of 1 % of a cap's irradiance.
inline void chart_caps(course::Chapter& chapter) {
    auto chart = chapter.chart("cap_light", "A lamp that is a cap of the sky about the zenith",
                               course::with_error({.x   = "half-angle of the cap [deg]",
                                                   .y   = "samples for an error of 1 %",
                                                   .log = course::axis::xy}));
    add_caps(chapter, chart, "uniform", 92300, [](const CapLight&) { return UniformDirections{}; });
    add_caps(chapter, chart, "by the cosine", 92400, [](const CapLight&) { return CosineDirections{}; });
    add_caps(chapter, chart, "in the cone", 500,
             [](const CapLight& cap) { return ConeDirections{cap.sine}; });
    const std::string one = "one sample";
    for (const double angle : {1.0, 80.0}) chart.add(one, angle, {1, 0});
    chart.as_line(one);
    chart.as_dashed(one);
    chart.in_ink(one, course::Ink::grey);
    chart.as_points("measured");
    chart.in_ink("measured", course::Ink::black);
    chart.in_ink("by the cosine", course::Ink::vermilion);
    chart.in_ink("in the cone", course::Ink::green);
    chart.caption(
        "Lines: exactly. Dots: by the variance of 262 144 samples, with standard errors. Below the dashed "
        "line "
        "one sample is enough.");
    const course::Claims claim{chapter, "9.2"};
    const CapLight       cap     = cap_of(10);
    const double         uniform = cap_variance(UniformDirections{}, cap),
                 cosine          = cap_variance(CosineDirections{}, cap);
    const double cone            = cap_variance(ConeDirections{cap.sine}, cap);
    claim("cap of 10 degrees: irradiance [L sr]", 0.0947, cap.irradiance(), 5e-5);
    claim("cap of 10 degrees: variance, uniform", 0.582, uniform, 0.0005);
    claim("cap of 10 degrees: variance, by the cosine", 0.289, cosine, 0.0005);
    claim("cap of 10 degrees: variance in the cone", 1.75e-7, cone, 5e-10);
    claim("cap of 10 degrees: variance, by the cosine, over that in the cone, in millions", 1.65,
          cosine / cone / 1e6, 0.005);
    claim("cap of 10 degrees: samples for 1 %, uniform", 648'000, needed(cap, uniform), 500);
    claim("cap of 10 degrees: samples for 1 %, by the cosine", 322'000, needed(cap, cosine), 500);
    claim("half-angle from which the cosine is better than the cone [deg]", 72.7, even_caps().value(), 0.05);
}

}  // namespace sr
