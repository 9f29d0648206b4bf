#pragma once
/// @file heavy_tail_charts.hpp
/// Section 9.10: means that jump, errors that do not fall by the root, and what clamping does.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "course/claims.hpp"
#include "heavy_tails.hpp"
#include "moments.hpp"
#include "repeated.hpp"
#include "statistics/slope.hpp"

namespace sr {

/// Means of 1 / r^2 as samples come in, of four runs.
inline void chart_jumps(course::Chapter& chapter) {
    auto   chart     = chapter.chart("jumps", "The mean of $1/r^2$ in a ball, four runs",
                                     {.x = "samples", .y = "mean so far", .log = course::axis::x});
    double late_lift = 0;  // of the mean by one sample, after a million
    for (int run = 1; run <= 4; ++run) {
        const std::string name = fmt::format("run {}", run);
        Rng               rng{1000, run, 0, 0};
        double            sum  = 0;
        double            next = 64;
        for (int n = 1; n <= 1 << 20; ++n) {
            const double value = draw_in_ball(unclamped, rng);
            sum += value;
            if (n >= 1'000'000) late_lift = std::max(late_lift, value / n);
            if (n < next) continue;
            chart.add(name, n, sum / n);
            next = n * 1.01;
        }
        chart.as_line(name);
    }
    for (const int n : {64, 1 << 20}) chart.add("exact", n, 3);
    chart.as_line("exact");
    chart.in_ink("exact", course::Ink::grey);
    const course::Claims claim{chapter, "9.10"};
    claim("mean of 1/r^2: greatest lift by one sample after a million", 0.07, late_lift, 5e-3);
    chart.caption("Rare samples count so much that they lift the mean of all before them.");
}

/// The median of the relative errors of n samples against n, 16 to 16384; what it falls by is returned.
/// @param draw  (Rng&) -> a sample with the mean `truth`
template <class Draw>
[[nodiscard]] Slope add_medians(course::Chart chart, const std::string& name, std::uint64_t stream,
                                int repeats, int threads, double truth, const Draw& draw) {
    std::vector<double>   samples;
    std::vector<Estimate> medians;
    for (int n = 16; n <= 16'384; n *= 4) {
        const auto error = median(repeated(repeats, threads, [&](std::uint64_t repeat) {
            Rng    rng{stream, std::int64_t(repeat), n, 0};
            double sum = 0;
            for (int i = 0; i < n; ++i) sum += draw(rng);
            return std::abs(sum / n / truth - 1);
        }));
        chart.add(name, n, error);
        samples.push_back(n);
        medians.push_back(error);
    }
    return log_log_slope(samples, medians);
}

inline void chart_heavy_tails(course::Chapter& chapter) {
    auto chart = chapter.chart(
        "heavy_tails", "Without a variance, errors fall more slowly",
        course::with_error({.x = "samples", .y = "relative error, median", .log = course::axis::xy}));
    const int            threads = chapter.options().threads;
    const course::Claims claim{chapter, "9.10"};
    const auto claim_slope = [&](const std::string& name, const Slope& slope, double printed, double error) {
        claim(name + ": power with which the median error falls", printed, -slope.value, 5e-4);
        claim(name + ": its standard error", error, slope.standard_error, 5e-4);
    };
    claim_slope("x^2",
                add_medians(chart, "$x^2$", 1001, 512, threads, 1.0 / 3,
                            [](Rng& rng) { return square(rng.uniform<double>()); }),
                0.503, 0.008);
    claim_slope("1/sqrt(x)",
                add_medians(chart, "$x^{-1/2}$", 1002, 512, threads, 2,
                            [](Rng& rng) { return draw_root(unclamped, rng); }),
                0.415, 0.009);
    claim_slope("1/r^2",
                add_medians(chart, "$1/r^2$", 1003, 512, threads, 3,
                            [](Rng& rng) { return draw_in_ball(unclamped, rng); }),
                0.323, 0.008);
    for (const int clamp : {10, 100}) {
        const std::string name = fmt::format("$1/r^2$, clamped at {}", clamp);
        (void)add_medians(chart, name, 1003 + std::uint64_t(clamp), 128, threads, 3,
                          [=](Rng& rng) { return draw_in_ball(clamp, rng); });
        chart.as_dashed(name);
    }
    chart.caption("Medians over 512 runs (clamped: 128). Clamped, the error stays where its bias is.");
}

/// The table of clamped means and variances, exact and measured.
inline void claim_clamped(course::Chapter& chapter) {
    const course::Claims claim{chapter, "9.10"};
    struct Row {
        double clamp, mean, variance, mean_in_ball, variance_in_ball, seen, seen_error;
    };
    for (const auto& row :
         {Row{10, 1.9, 2.00, 2.37, 4.04, 2.365, 0.004}, Row{100, 1.99, 6.25, 2.80, 29.2, 2.802, 0.011},
          Row{1000, 1.999, 10.8, 2.94, 114.9, 2.956, 0.023}}) {
        const auto root = clamped_root(row.clamp), in_ball = clamped_in_ball(row.clamp);
        const auto at = fmt::format("clamped at {}, ", row.clamp);
        claim(at + "1/sqrt(x): mean", row.mean, root.mean, 5e-4);
        claim(at + "1/sqrt(x): variance", row.variance, root.variance, row.clamp < 1000 ? 5e-3 : 5e-2);
        claim(at + "1/r^2: mean", row.mean_in_ball, in_ball.mean, 5e-3);
        claim(at + "1/r^2: variance", row.variance_in_ball, in_ball.variance, row.clamp > 10 ? 5e-2 : 5e-3);
        const auto seen =
            moments_of(
                1020, [&](Rng& rng) { return draw_in_ball(row.clamp, rng); }, chapter.options().threads)
                .mean;
        claim(at + "1/r^2: mean, measured", row.seen, seen.value, 5e-4);
        claim(at + "1/r^2: its standard error", row.seen_error, seen.error, 5e-4);
    }
}

}  // namespace sr
