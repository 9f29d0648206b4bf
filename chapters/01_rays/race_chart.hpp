#pragma once
/// @file race_chart.hpp
/// The charts of the race, and where two of their curves cross.

#include <fmt/format.h>

#include <cmath>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "course/chapter.hpp"
#include "race.hpp"

namespace sr {

/// Where the curve a rises above the curve b, between the points at x, as straight lines on logarithmic axes.
[[nodiscard]] inline std::optional<double> crossing(const std::vector<double>& x,
                                                    const std::vector<double>& a,
                                                    const std::vector<double>& b) {
    for (std::size_t i = 1; i < x.size(); ++i) {
        const double before = std::log(a[i - 1] / b[i - 1]), after = std::log(a[i] / b[i]);
        if (before <= 0 && after > 0) return x[i - 1] * std::pow(x[i] / x[i - 1], before / (before - after));
    }
    return std::nullopt;
}

/// What has been charted so far, by method.
struct Curves {
    std::vector<double>                        x;
    std::map<std::string, std::vector<double>> seconds;
};

/// Seconds against what grows, with the spread of the repeats, and the columns of every speed/accuracy chart.
[[nodiscard]] inline course::Axes race_axes(const std::string& x) {
    course::Axes axes{.x = x, .y = "time for an image [s]", .log = course::axis::xy};
    axes.columns       = course::speed_accuracy({"triangles", "pixels", "seconds_min", "seconds_max"});
    axes.columns.x     = "effort";
    axes.columns.y     = "seconds";
    axes.columns.error = "";
    axes.columns.min   = "seconds_min";
    axes.columns.max   = "seconds_max";
    return axes;
}

/// The laps of one race, as rows of the chart and points of the curves.
inline void add(course::Chart& chart, Curves& curves, const Race& race, const std::vector<Lap>& laps,
                double effort) {
    curves.x.push_back(effort);
    for (const auto& lap : laps) {
        chart.row({lap.method, effort, lap.seconds, lap.error, lap.error_se, race.triangles(), race.pixels(),
                   lap.seconds_min, lap.seconds_max});
        curves.seconds[lap.method].push_back(lap.seconds);
    }
}

/// A number in TeX to two digits: 1.5 x 10^5.
[[nodiscard]] inline std::string two_digits(double number) {
    const auto digits = fmt::format("{:.1e}", number);
    const auto e      = digits.find('e');
    return fmt::format("${}\\cdot 10^{{{}}}$", digits.substr(0, e), std::stoi(digits.substr(e + 1)));
}

/// Marks where one method begins to take longer than another, and says so.
inline std::string mark_crossing(course::Chart& chart, const Curves& curves, const std::string& slower,
                                 const std::string& faster, const std::string& unit) {
    const auto x = crossing(curves.x, curves.seconds.at(slower), curves.seconds.at(faster));
    if (!x) return fmt::format("\"{}\" and \"{}\" do not cross.", slower, faster);
    chart.mark_x(*x, two_digits(*x));
    return fmt::format("\"{}\" takes longer than \"{}\" from {} {} on.", slower, faster, two_digits(*x),
                       unit);
}

}  // namespace sr
