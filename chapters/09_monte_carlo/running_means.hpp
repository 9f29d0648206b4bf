#pragma once
/// @file running_means.hpp
/// The mean of more and more samples: figure 9.2.

#include <cmath>
#include <string>
#include <vector>

#include "course/chapter.hpp"
#include "estimator.hpp"
#include "first_integral.hpp"

namespace sr {

/// Five runs, and how far (9.3) lets one of them be off.
inline void chart_running_means(course::Chapter& chapter) {
    auto chart = chapter.chart("running_means", "Five runs that differ in their random numbers alone",
                               {.x = "samples $n$", .y = "mean of $n$ samples", .log = course::axis::x});
    std::vector<int> counts;
    for (int k = 16; k <= 64; ++k) counts.push_back(int(std::lround(std::exp2(k / 4.0))));
    const double      I = growth_integral(), sigma = std::sqrt(growth_variance(EvenDensity{}));
    const std::string runs = "five runs";
    for (int run = 1; run <= 5; ++run) {
        if (run > 1) chart.gap(runs, counts.front());
        Rng     rng{91, run, 0, 0};
        Running mean;
        for (const int n : counts) {
            mean.merge(monte_carlo(rng, growth, EvenDensity{}, n - int(mean.count())));
            chart.add(runs, n, mean.mean());
        }
    }
    chart.as_line(runs);
    for (const double side : {1.0, -1.0}) {
        const std::string name = side > 0 ? "$I + \\sigma[F_n]$" : "$I - \\sigma[F_n]$";
        for (const int n : counts) chart.add(name, n, I + side * sigma / std::sqrt(n));
        chart.as_line(name);
        chart.as_dashed(name);
        chart.in_ink(name, course::Ink::black);
    }
    chart.caption(
        "Drawn by $p = 1/2$. At any $n$, about two of three runs lie between the dashed lines. A run may "
        "well stay on one side.");
}

}  // namespace sr
