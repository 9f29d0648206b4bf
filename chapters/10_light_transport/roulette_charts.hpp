#pragma once
/// @file roulette_charts.hpp
/// Section 10.4: variance against the chance of going on, what it is worth, and where it is infinite.

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "course/claims.hpp"
#include "known_scenes.hpp"
#include "math/square.hpp"
#include "roulette_furnace.hpp"
#include "roulette_runs.hpp"
#include "scene/small_scenes.hpp"

namespace sr {

/// Means, variances and bounces of three furnaces, within four standard errors of the closed forms.
inline void claim_roulette(course::Chapter& chapter) {
    const course::Claims claim{chapter, "10.4"};
    course::Rows         table{{"rho", "q", "mean", "variance", "bounces"}};
    struct Row {
        double rho, q, mean, variance, digit, bounces;
    };
    for (const auto& [rho, q, mean, variance, digit, bounces] :
         {Row{0.5, 0.5, 2, 2, 1, 1}, Row{0.5, 0.8, 2, 0.364, 1e-3, 4}, Row{0.9, 0.9, 10, 90, 1, 9}}) {
        const RouletteFurnace furnace{rho, q};
        const auto            run  = run_roulette(furnace, chapter.options().threads);
        const auto            of   = fmt::format("roulette, rho {} and q {}: ", rho, q);
        const double          root = std::sqrt(double(RouletteRun::paths));
        claim(of + "variance by the formula", variance, furnace.variance(), digit / 2);
        // four standard errors
        claim(of + "mean of the paths", mean, run.light.value, 4 * std::sqrt(furnace.variance()) / root);
        claim(of + "variance of the paths", variance, run.variance.value,
              4 * furnace.error_of_variance(RouletteRun::paths) + digit / 2);
        claim(of + "bounces", bounces, run.surfaces.value - 1, 4 * std::sqrt(q) / (1 - q) / root);
        table.add({rho, q, run.light.value, run.variance.value, run.surfaces.value - 1});
    }
    chapter.say(table);
}

/// The same of the path tracer itself, in a ball that shines and reflects 0.9.
inline void claim_traced_roulette(course::Chapter& chapter) {
    constexpr int    paths = 1 << 16;
    const KnownScene ball{"ball", inside_of_a_ball(0.9F, 1), {{0, 0, 0}, {1, 2, 3}}, 10};
    const auto       light =
        traced_mean(ball, paths, chapter.options().threads, {.strategy = Strategy::bsdf, .roulette = 0});
    const course::Claims claim{chapter, "10.4"};
    claim("path tracer in a ball of 0.9: variance", 90, light.variance(),
          4 * RouletteFurnace{0.9, 0.9}.error_of_variance(paths));
}

/// Variance over the squared mean, by the formula and measured.
inline void chart_roulette_variance(course::Chapter& chapter) {
    auto chart = chapter.chart("roulette_variance", "What roulette costs in noise",
                               course::with_error({.x   = "chance of going on $q$",
                                                   .y   = "variance of a path / squared mean",
                                                   .log = course::axis::y}));
    for (const double rho : {0.5, 0.9}) {
        const auto   ink   = rho < 0.7 ? course::Ink::blue : course::Ink::vermilion;
        const auto   name  = fmt::format("$\\rho = {}$, closed form", rho);
        const double cliff = square(rho);
        for (int i = 1; i < 100; ++i) {
            // close together at either end
            const double          part = square(std::sin(0.5 * std::numbers::pi * i / 100));
            const RouletteFurnace furnace{rho, cliff + (1 - cliff) * part};
            const double          relative = furnace.variance() / square(furnace.mean());
            if (relative < 100 && relative > 0.01) chart.add(name, furnace.q, {relative, 0});
        }
        chart.as_line(name);
        chart.in_ink(name, ink);
        chart.mark_x(cliff, fmt::format("$\\rho^2 = {:.2g}$", cliff), ink);
    }
    for (const double rho : {0.5, 0.9}) {
        const auto name = fmt::format("$\\rho = {}$, measured", rho);
        for (const double part : {0.05, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9}) {
            const RouletteFurnace furnace{rho, square(rho) + (1 - square(rho)) * part};
            const auto            run   = run_roulette(furnace, chapter.options().threads);
            const double          scale = square(furnace.mean());
            chart.add(name, furnace.q, {run.variance.value / scale, run.variance.error / scale});
        }
        chart.as_points(name);
        chart.in_ink(name, rho < 0.7 ? course::Ink::blue : course::Ink::vermilion);
    }
    chart.caption("262 144 paths for each point. At $q = \\rho^2$ the variance becomes infinite.");
}

/// Variance times cost, for noise of other kinds.
inline void chart_roulette_cost(course::Chapter& chapter) {
    auto                      chart = chapter.chart("roulette_cost", "Variance times cost, for $\\rho = 0.9$",
                                                    course::with_error({.x = "chance of going on $q$",
                                                                        .y = "variance / squared mean $\\times$ surfaces",
                                                                        .log = course::axis::y}));
    const auto                name  = [](double noise) { return fmt::format("$v = {}$", noise); };
    constexpr double          rho   = 0.9;
    const std::vector<double> noises{10, 1, 0.1, 0};
    for (const double noise : noises) {
        for (int i = 0; i <= 150; ++i) {
            const RouletteFurnace furnace{rho, 0.8115 + 0.00124 * i};
            const double          cost = roulette_cost(furnace, noise);
            if (cost < 600) chart.add(name(noise), furnace.q, {cost, 0});
        }
        chart.as_line(name(noise));
    }
    for (const double noise : noises) {
        for (const double q : {0.87, 0.89, 0.91, 0.93, 0.95, 0.97}) {
            const auto run = run_roulette({rho, q}, chapter.options().threads, noise);
            chart.add("measured", q, run.cost);
        }
        chart.gap("measured", 0.97);
    }
    chart.as_points("measured");
    chart.in_ink("measured", course::Ink::black);
    chart.mark_x(square(rho), "$\\rho^2$");
    chart.mark_x(rho, "$\\rho$");
    chart.caption("$v$ is what else is random in a path: its variance, in squared means.");
}

/// The q of least variance times cost, looked for in steps of 0.0001.
[[nodiscard]] inline double search_survival(double rho, double noise) {
    RouletteFurnace best{rho, square(rho) + 1e-4};
    for (RouletteFurnace one = best; one.q < 1; one.q += 1e-4)
        if (roulette_cost(one, noise) < roulette_cost(best, noise)) best = one;
    return best.q;
}

inline void claim_best_survival(course::Chapter& chapter) {
    const course::Claims claim{chapter, "10.4"};
    for (const auto& [rho, noise, printed] :
         {std::tuple{0.9, 10.0, 0.852}, {0.9, 1.0, 0.9}, {0.9, 0.1, 0.951}, {0.5, 1.0, 0.5}}) {
        const auto of = fmt::format("rho {}, noise of {} squared means: best q ", rho, noise);
        claim(of + "by the formula", printed, best_survival(rho, noise), 5e-4);
        claim(of + "by search", printed, search_survival(rho, noise), 6e-4);
    }
}

/// Means of more and more paths where nearly all light is reflected: with a q that is large enough, and without.
inline void chart_infinite_variance(course::Chapter& chapter) {
    auto          chart = chapter.chart("infinite_variance", "A white room, $\\rho = 0.99$",
                                        {.x = "paths", .y = "mean of a path so far", .log = course::axis::x});
    constexpr int last  = 1 << 18;
    const auto    add   = [&](const std::string& name, double q, int run) {
        Rng    rng{105, run, 0, 0};
        double sum = 0, next = 256;
        for (int n = 1; n <= last; ++n) {
            sum += RouletteFurnace{0.99, q}.draw(rng).light;
            if (n < next && n != last) continue;
            chart.add(name, n, sum / n);
            next = n * 1.01;
        }
        chart.as_line(name);
    };
    for (int run = 1; run <= 4; ++run) add(fmt::format("$q = 0.95$, run {}", run), 0.95, run);
    add("$q = 0.99$", 0.99, 5);
    chart.in_ink("$q = 0.99$", course::Ink::black);
    for (const int n : {256, last}) chart.add("exact", n, 100);
    chart.as_line("exact");
    chart.in_ink("exact", course::Ink::grey);
    const course::Claims claim{chapter, "10.4"};
    for (const auto& [run, printed] : {std::pair{1, 119.0}, {2, 97.0}, {3, 86.0}, {4, 89.0}})
        claim(fmt::format("white room, q 0.95, run {}: mean of 262144 paths", run), printed,
              chart.at(fmt::format("$q = 0.95$, run {}", run), last), 0.5);
    claim("white room: rho^2", 0.98, square(0.99), 5e-3);
    claim("white room, q 0.99: mean of 262144 paths", 100, chart.at("$q = 0.99$", last),
          4 * std::sqrt(RouletteFurnace{0.99, 0.99}.variance() / last));
    chart.caption("$q = 0.95$ is below $\\rho^2 = 0.98$: most runs are too dark, until a path jumps.");
}

}  // namespace sr
