#pragma once
/// @file density_charts.hpp
/// Section 9.5: the same integral by densities that are too flat, right, and too steep.

#include <cmath>
#include <cstdint>
#include <utility>

#include "course/chapter.hpp"
#include "moments.hpp"
#include "power_density.hpp"

namespace sr {

/// What a sample counts, against where it falls.
inline void chart_what_counts(course::Chapter& chapter) {
    auto chart = chapter.chart("what_counts", "What a sample of $x^2$ counts",
                               {.x = "$x$", .y = "$f(x) / p(x)$", .log = course::axis::none});
    for (const auto& [name, a] :
         {std::pair{"$p = 1$", 1.0}, {"$p = 2x$", 2.0}, {"$p = 3x^2$", 3.0}, {"$p = 4x^3$", 4.0}}) {
        for (int i = a > 3 ? 20 : 0; i <= 100; ++i) {
            const double x = i / 100.0;
            chart.add(name, x, std::pow(x, 3 - a) / a);
        }
        chart.as_line(name);
    }
    chart.caption("All have the mean 1/3, each by its own density. One of them is 1/3.");
}

/// The variance of one sample against the density's exponent.
inline void chart_exponents(course::Chapter& chapter) {
    auto chart = chapter.chart("exponents", "Variance of one sample of $x^2$, drawn with $p = a x^{a-1}$",
                               course::with_error({.x = "$a$", .y = "variance", .log = course::axis::y}));
    for (int i = 8; i <= 116; ++i) {
        if (i != 60)
            chart.add("exact", i / 20.0, Estimate{variance_of_square(i / 20.0)});
        else
            chart.gap("exact", 3);
    }
    for (const double a : {0.5, 1.0, 1.5, 2.0, 2.5, 3.5, 4.0, 4.5, 5.0, 5.5, 5.8}) {
        const auto draw = [=](Rng& rng) { return draw_square({a}, rng); };
        chart.add("measured", a, moments_of(std::uint64_t(10 * a), draw, chapter.options().threads).variance);
    }
    chart.as_line("exact");
    chart.as_points("measured");
    chart.mark_x(3, "$3x^2$");
    chart.caption(
        "A quarter of a million samples for each dot. At the right they don't show the variance that they "
        "have.");
}

}  // namespace sr
