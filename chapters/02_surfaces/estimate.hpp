#pragma once
/// @file estimate.hpp
/// What is counted of random rays, with its standard error, and charts that show both.

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "course/chart.hpp"

namespace sr {

/// A number that random rays know, and one standard error of it.
struct Estimate {
    double value = 0;
    double error = 0;
};

/// The share of n rays that `count` of them are. Its error is that of (count + 1) / (n + 2), Laplace's estimate: that
/// nothing was seen in n rays does not say that there is nothing.
[[nodiscard]] inline Estimate share(int count, std::size_t n) {
    const double p = (count + 1) / (double(n) + 2);
    return {count / double(n), std::sqrt(p * (1 - p) / double(n))};
}

[[nodiscard]] inline Estimate percent(Estimate share) {
    return {100 * share.value, 100 * share.error};
}

/// The median, and half the distance of the two values that lie as many ranks above and below it as the number of
/// values under the median varies by: sqrt(n) / 2.
/// @pre values is not empty
[[nodiscard]] inline Estimate median(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    const double n  = double(values.size());
    const auto   at = [&](double rank) { return values[std::size_t(std::clamp(rank, 0.0, n - 1))]; };
    return {at(n / 2), (at(n / 2 + std::sqrt(n) / 2) - at(n / 2 - std::sqrt(n) / 2)) / 2};
}

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
