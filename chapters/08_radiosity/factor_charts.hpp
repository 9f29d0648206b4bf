#pragma once
/// @file factor_charts.hpp
/// Section 8.3: error against time, for four pairs of squares.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "course/chapter.hpp"
#include "factor_methods.hpp"
#include "statistics/running.hpp"
#include "statistics/slope.hpp"

namespace sr {

/// A relative error; by chance, the root of the mean square over repeats, and its standard error.
struct FactorError {
    double value = 0, se = 0;
};

/// What one run of a method costs is the time of all its repeats over their number.
[[nodiscard]] inline int repeats_of(const FactorMethod& method) {
    return method.by_chance ? 32 : 1;
}

[[nodiscard]] inline FactorError factor_error(const FactorMethod& method, double effort, double exact) {
    Running squares;
    for (int repeat = 0; repeat < repeats_of(method); ++repeat) {
        Rng rng{8, std::int64_t(effort), repeat, 0};
        squares.add(square(method.compute(effort, rng) / exact - 1));
    }
    const double rms = std::sqrt(squares.mean());
    return {rms, method.by_chance && rms > 0 ? squares.standard_error() / (2 * rms) : 0};
}

/// All methods with all their efforts on one pair, timed on one thread.
class FactorRace {
public:
    struct Point {
        std::string method;
        double      effort, seconds;
        FactorError error;
    };

    FactorRace(const KnownPair& pair, int repeats) {
        const Visibility          visibility = pair.visibility();
        const CosineRays          rays(pair.patches);
        const auto                methods = factor_methods(pair, visibility, rays);
        std::vector<course::Work> works;
        for (const FactorMethod& method : methods)
            for (const double effort : method.efforts) {
                points_.push_back({method.name, effort, 1.0 / repeats_of(method), {}});
                works.push_back({method.name, [&, effort, at = points_.size() - 1] {
                                     points_[at].error = factor_error(method, effort, pair.exact);
                                 }});
            }
        const auto timings = course::measure(works, repeats);
        for (std::size_t i = 0; i < works.size(); ++i) points_[i].seconds *= timings[i].seconds;
    }

    /// All methods on a chart. Where nothing is left of an error, rounding is.
    void fill(course::Chart chart) const {
        for (const Point& point : points_) {
            chart.row(cells(point));
            chart.in_ink(point.method, ink_of_method(point.method));
        }
    }

    /// The same among other pairs: all are kept with the pair's name, and some methods drawn.
    void fill(course::Chart chart, const std::string& pair, const std::set<std::string>& drawn) const {
        for (const Point& point : points_) {
            const bool        shown = drawn.contains(point.method);
            const std::string curve = shown ? pair + ": " + point.method : "";
            auto              row   = cells(point);
            row.insert(row.end(), {pair, curve});
            chart.row(row);
            if (shown) chart.in_ink(curve, ink_of_method(point.method));
        }
    }

    [[nodiscard]] const std::vector<Point>& points() const { return points_; }

    [[nodiscard]] FactorError error(const std::string& method, double effort) const {
        for (const Point& point : points_)
            if (point.method == method && point.effort == effort) return point.error;
        throw std::out_of_range(fmt::format("{} has no effort {}", method, effort));
    }

    /// The power of its effort with which a method's error falls, over the largest ones.
    [[nodiscard]] Slope slope(const std::string& method, double from_effort) const {
        std::vector<double> efforts, errors;
        for (const Point& point : points_) {
            if (point.method != method || point.effort < from_effort) continue;
            efforts.push_back(point.effort);
            errors.push_back(point.error.value);
        }
        return log_log_slope(efforts, errors);
    }

private:
    static std::vector<course::Cell> cells(const Point& point) {
        constexpr double rounding = 1e-16;
        return {point.method, point.effort, point.seconds, std::max(point.error.value, rounding),
                point.error.se};
    }

    std::vector<Point> points_;
};

[[nodiscard]] inline course::Chart factor_chart(course::Chapter& chapter, const std::string& name,
                                                const std::string&     title,
                                                const course::Columns& columns = course::speed_accuracy()) {
    return chapter.chart(name, title,
                         {.x       = "time for one form factor [s]",
                          .y       = "relative error",
                          .log     = course::axis::xy,
                          .columns = columns});
}

/// All methods on each pair, and on all pairs, where the best two are drawn.
[[nodiscard]] inline std::map<std::string, FactorRace> chart_form_factors(course::Chapter& chapter) {
    const int                         repeats = chapter.options().quality == course::Quality::draft ? 1 : 5;
    std::map<std::string, FactorRace> races;
    course::Progress                  progress("computing form factors", 4);
    auto                              columns = course::speed_accuracy({"pair", "curve"});
    columns.series                            = "curve";
    auto all = factor_chart(chapter, "form_factors", "Four pairs of unit squares, two methods", columns);
    for (const KnownPair& pair : known_pairs()) {
        const auto& race  = races.emplace(pair.name, FactorRace(pair, repeats)).first->second;
        auto        chart = factor_chart(chapter, "form_factors_" + pair.name, "Unit squares, " + pair.name);
        race.fill(chart);
        chart.caption("By chance: the root of the mean square over 32 repeats, with standard errors.");
        const std::string contour = pair.patches.size() > 2 ? "contour and rays" : "contour, adaptive";
        race.fill(all, pair.name, {contour, "random pairs"});
        progress.tick();
    }
    all.caption("An edge that the squares share is cut small; what is hidden takes rays.");
    return races;
}

}  // namespace sr
