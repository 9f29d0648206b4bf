#pragma once
/// @file rejection_cost.hpp
/// What rejection costs: trials, and time.

#include <fmt/format.h>

#include <cmath>
#include <cstdint>
#include <numbers>
#include <stdexcept>
#include <tuple>

#include "course/claims.hpp"
#include "math/extremes.hpp"
#include "math/square.hpp"
#include "moments.hpp"
#include "sampling/hemisphere.hpp"
#include "sampling/inversion.hpp"
#include "sampling/power_cosine.hpp"
#include "sampling/rejection.hpp"

namespace sr {

/// The share of a cube that its ball fills, in d dimensions: pi^(d/2) / (2^d Gamma(d/2 + 1)).
[[nodiscard]] inline double ball_in_cube(int d) {
    return std::exp(d / 2.0 * std::log(std::numbers::pi) - d * std::numbers::ln2 - std::lgamma(d / 2.0 + 1));
}

/// Whether a point of the cube, drawn coordinate by coordinate, lies in the ball. Those after the one that is too much
/// are not drawn.
[[nodiscard]] inline bool falls_into_ball(Rng& rng, int d) {
    double squares = 0;
    for (int i = 0; i < d; ++i) {
        squares += square(2 * rng.uniform<double>() - 1);
        if (squares > 1) return false;
    }
    return true;
}

/// How many points of the cube it takes until one lies in the ball.
[[nodiscard]] inline int trials_until_in_ball(Rng& rng) {
    int trials = 1;
    while (!falls_into_ball(rng, 3)) ++trials;
    return trials;
}

/// The variance of the trials, (9.13), and that of ten million: its error is that of its mean over 40 parts.
inline void claim_variance_of_trials(course::Chapter& chapter) {
    const double a = ball_in_cube(3), exact = (1 - a) / square(a);
    Running      seen;
    for (std::uint64_t part = 0; part < 40; ++part)
        seen.add(moments_of(94'400 + part, trials_until_in_ball, chapter.options().threads).variance.value);
    const course::Claims claim{chapter, "9.4"};
    claim("ball, 3 dimensions: variance of trials", 1.738, exact, 0.0005);
    claim("ball, 3 dimensions: variance of trials, measured", 1.7375, seen.mean(), 5e-5);
    claim("its standard error", 0.0015, seen.standard_error(), 5e-5);
    chapter.claim_at_most("9.4 variance of trials off [standard errors]",
                          std::abs(seen.mean() - exact) / seen.standard_error(), 4);
}

/// Figure 9.8: trials for a point of the ball.
inline void chart_trials(course::Chapter& chapter) {
    auto chart = chapter.chart(
        "trials", "Points of a ball, drawn in the cube around it",
        course::with_error({.x = "dimensions", .y = "trials for a point", .log = course::axis::y}));
    for (int d = 2; d <= 20; ++d) chart.add("exactly", d, {1 / ball_in_cube(d), 0});
    double worst = 0;
    for (const int d : {2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12}) {
        const auto seen =
            moments_of(
                9400 + std::uint64_t(d), [=](Rng& rng) { return falls_into_ball(rng, d) ? 1 : 0; },
                chapter.options().threads)
                .mean;
        chart.add("measured", d, {1 / seen.value, seen.error / square(seen.value)});
        const double p = ball_in_cube(d);
        worst          = max_or_nan(worst, std::abs(seen.value - p) / std::sqrt(p * (1 - p) / 0x1p18));
    }
    chart.as_line("exactly");
    chart.as_points("measured");
    chart.caption("Dots: 262 144 trials each, with standard errors.");
    chapter.claim_at_most("9.4 points of balls: share accepted off [standard errors]", worst, 4);
    const course::Claims claim{chapter, "9.4"};
    claim("ball, 2 dimensions: trials", 1.273, 1 / ball_in_cube(2), 0.0005);
    claim("ball, 3 dimensions: trials", 1.910, 1 / ball_in_cube(3), 0.0005);
    claim("ball, 10 dimensions: trials", 401.5, 1 / ball_in_cube(10), 0.05);
    claim("ball, 20 dimensions: trials, in millions", 40.6, 1e-6 / ball_in_cube(20), 0.05);
}

/// A direction with a density like cos^e, by rejection from the uniform hemisphere.
[[nodiscard]] inline auto reject_lobe(Rng& rng, double e, int most_trials) {
    return sample_by_rejection(
        rng, [](Rng& one) { return sample_uniform_hemisphere(draw_pair(one)); },
        [](const Vector3<double>& w) { return pdf_uniform_hemisphere(w).value; }, 2 * std::numbers::pi,
        [=](const Vector3<double>& w) { return std::pow(w.z, e); }, most_trials);
}

/// Trials of a lobe, e + 1 of them, and those that end without a direction.
inline void claim_lobes(course::Chapter& chapter) {
    const course::Claims claim{chapter, "9.4"};
    for (const auto& [e, printed, error, digit] :
         {std::tuple{1, 2.00, 0.01, 0.01}, {10, 11.1, 0.1, 0.1}, {100, 99.2, 1.0, 0.1}}) {
        Rng     rng{945, e, 0, 0};
        Running trials;
        for (int i = 0; i < 10'000; ++i) trials.add(reject_lobe(rng, e, 100'000).value().trials);
        claim(fmt::format("lobe, exponent {}: trials", e), printed, trials.mean(), digit / 2);
        claim(fmt::format("lobe, exponent {}: standard error of that", e), error, trials.standard_error(),
              digit / 2);
        chapter.claim_at_most(fmt::format("9.4 lobe, exponent {}: trials off [standard errors]", e),
                              std::abs(trials.mean() - (e + 1)) / trials.standard_error(), 4);
    }
    Rng rng{946, 0, 0, 0};
    int none = 0;
    for (int i = 0; i < 1000; ++i) none += reject_lobe(rng, 1e4, 1000) ? 0 : 1;
    claim("lobe, exponent 10 000, 1000 trials: without a direction, of 1000", 898, none, 0.5);
    claim("and expected, of 1000", 905, 1000 * std::pow(1 - 1 / 10'001.0, 1000), 0.5);
}

/// Figure 9.10: time for a direction, by three ways.
inline void chart_rejection_time(course::Chapter& chapter) {
    auto chart = chapter.chart(
        "rejection_time", "Directions that follow $\\cos^e$, by three ways",
        {.x = "exponent $e$", .y = "time for a direction, one thread [ns]", .log = course::axis::xy});
    constexpr int n     = 1000;
    const auto    total = [](const Vector3<double>& w) {
        return w.x + w.y + w.z;
    };  // or what isn't needed isn't computed
    for (const double e : {1.0, 2.0, 5.0, 10.0, 20.0, 50.0, 100.0}) {
        double     sum = 0;  // looked at below: work whose result nobody needs is optimised away
        Rng        rng{947, 0, 0, 0};
        const auto P     = [e](double z) { return std::pow(z, e + 1); };
        const auto times = course::measure(
            {{"rejection",
              [&] {
                  for (int i = 0; i < n; ++i) sum += total(reject_lobe(rng, e, 100'000).value().x);
              }},
             {"inversion, formula",
              [&] {
                  for (int i = 0; i < n; ++i) sum += total(sample_power_cosine(draw_pair(rng), e));
              }},
             {"inversion, search",
              [&] {
                  for (int i = 0; i < n; ++i) {
                      const auto   u = draw_pair(rng);
                      const auto   z = invert_cdf(P, Interval<double>{0, 1}, u.x).value().x;
                      const double r = std::sqrt((1 - z) * (1 + z)), phi = 2 * std::numbers::pi * u.y;
                      sum += total({r * std::cos(phi), r * std::sin(phi), z});
                  }
              }}},
            5);
        if (!(sum > 0)) throw std::logic_error("all directions are flat");
        for (const auto& time : times) chart.add(time.name, e, 1e9 * time.seconds / n);
    }
    chart.caption("All of them draw from the same density: the error of a sample is the same.");
}

}  // namespace sr
