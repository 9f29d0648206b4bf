#pragma once
/// @file estimate.hpp
/// Charts of estimates that show their standard errors.

#include <string>

#include "course/chart.hpp"
#include "statistics/estimate.hpp"

namespace sr {

/// Axes of a chart of estimates, with a bar of one standard error at each.
[[nodiscard]] inline course::Axes axes_with_error(const std::string& x, const std::string& y) {
    return {.x       = x,
            .y       = y,
            .log     = course::axis::xy,
            .columns = {.headers = {"series", x, y, "standard error"},
                        .series  = "series",
                        .x       = x,
                        .y       = y,
                        .error   = "standard error"}};
}

/// One point of a curve on such axes.
inline void add(course::Chart chart, const std::string& series, double x, Estimate y) {
    chart.add(series, x, y.value, {y.error});
}

}  // namespace sr
