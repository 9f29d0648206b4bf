#pragma once
/// @file race_chart.hpp
/// The charts of the race, and where their curves cross.

#include <fmt/format.h>

#include <cmath>
#include <iterator>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "course/chapter.hpp"
#include "course/number.hpp"
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
    std::vector<double>                        x        = {};
    std::map<std::string, std::vector<double>> seconds  = {};
    std::vector<double>                        building = {};  ///< [s] of the hierarchy alone
};

/// Seconds against what grows, with a bar up to the slowest repeat, and the columns of every speed/accuracy chart.
[[nodiscard]] inline course::Axes race_axes(const std::string& x) {
    course::Axes axes{.x = x, .y = "time for an image [s]", .log = course::axis::xy};
    axes.columns       = course::speed_accuracy({"triangles", "pixels", "slowest"});
    axes.columns.x     = "effort";
    axes.columns.y     = "seconds";
    axes.columns.error = "";
    axes.columns.min   = "seconds";
    axes.columns.max   = "slowest";
    return axes;
}

/// Runs one race, as rows of the chart and points of the curves.
inline void add(course::Chart& chart, Curves& curves, const Race& race, const course::Options& options,
                double effort) {
    const bool draft = options.quality == course::Quality::draft;
    curves.x.push_back(effort);
    for (const auto& lap : race.run(draft ? 1 : 3, draft ? 2e6 : 1.5e7, options.seed)) {
        chart.row({lap.method, effort, lap.seconds, lap.error, lap.error_se, race.triangles(), race.pixels(),
                   lap.slowest});
        curves.seconds[lap.method].push_back(lap.seconds);
    }
    curves.building.push_back(curves.seconds["rays, hierarchy and its building"].back() -
                              curves.seconds["rays, hierarchy"].back());
}

/// A number in TeX, to two digits: 1.5 x 10^5.
[[nodiscard]] inline std::string two_digits(double number) {
    const auto digits = fmt::format("{:.1e}", number);
    const auto e      = digits.find('e');
    return fmt::format("${}\\cdot 10^{{{}}}$", digits.substr(0, e), std::stoi(digits.substr(e + 1)));
}

/// What both captions end with.
inline constexpr const char* scaled = " \"Rays, all triangles\" is timed on random pixels and scaled.";

/// Marks where one method begins to take longer than another, and says so.
inline std::string mark_crossing(course::Chart& chart, const Curves& curves, const std::string& slower,
                                 const std::string& faster) {
    const auto x = crossing(curves.x, curves.seconds.at(slower), curves.seconds.at(faster));
    if (!x) return fmt::format("\"{}\" and \"{}\" do not cross.", slower, faster);
    chart.mark_x(*x, two_digits(*x));
    return fmt::format("\"{}\" takes longer than \"{}\" from {} {} on.", slower, faster, two_digits(*x),
                       chart.data().axes.x);
}

/// The seconds of each method and, apart, of building the hierarchy.
[[nodiscard]] inline course::Rows times(const Curves& curves, const std::string& unit) {
    course::Rows table{
        {unit, "rasteriser [s]", "rays, all triangles [s]", "rays, hierarchy [s]", "its building [s]"}};
    const auto& of = curves.seconds;
    for (std::size_t i = 0; i < curves.x.size(); ++i)
        table.add({curves.x[i], of.at("rasteriser")[i], of.at("rays, all triangles")[i],
                   of.at("rays, hierarchy")[i], curves.building[i]});
    return table;
}

/// Who is faster at the least effort, and at how many triangles or pixels that ends, for all pairs of methods.
[[nodiscard]] inline course::Rows crossings(const Curves& curves, const std::string& unit) {
    course::Rows table{{"faster at first", "than", "up to so many " + unit}};
    for (auto one = curves.seconds.begin(); one != curves.seconds.end(); ++one) {
        for (auto two = std::next(one); two != curves.seconds.end(); ++two) {
            const bool  first  = one->second.front() <= two->second.front();
            const auto& faster = first ? *one : *two;
            const auto& slower = first ? *two : *one;
            const auto  x      = crossing(curves.x, faster.second, slower.second);
            table.add({faster.first, slower.first, x ? fmt::format("{:.1e}", *x) : "all charted"});
        }
    }
    return table;
}

/// Times are no claims: they are the machine's. The text quotes them in words.
inline void say_times(course::Chapter& chapter, const Curves& curves, const std::string& unit) {
    chapter.say(times(curves, unit));
    chapter.say(crossings(curves, unit));
    const auto& rays = curves.seconds.at("rays, hierarchy");
    chapter.say(fmt::format("\"rays, hierarchy\" takes {:.2g} times as long for {:.2g} times as many {}.",
                            rays.back() / rays.front(), curves.x.back() / curves.x.front(), unit));
    if (const auto x = crossing(curves.x, curves.building, rays))
        chapter.say(fmt::format("Its building takes longer than it from {:.1e} {} on.", *x, unit));
}

/// Figure 1.5: a race for each fineness of the teapot.
inline void race_by_triangles(course::Chapter& chapter, int side) {
    auto chart =
        chapter.chart("triangles", fmt::format("One image of ${0} \\times {0}$ pixels, one thread", side),
                      race_axes("triangles"));
    Curves                 curves;
    const std::vector<int> levels{1, 2, 4, 8, 16, 32, 64, 125};
    const auto             cost = [](int level) { return 140'000 + 64 * level * level; };  // measured once
    int                    all  = 0;
    for (const int level : levels) all += cost(level);
    course::Progress progress("racing by triangles", all);
    for (const int level : levels) {
        const Race race(level, side);
        add(chart, curves, race, chapter.options(), double(race.triangles()));
        progress.tick(cost(level));
    }
    chart.caption(mark_crossing(chart, curves, "rasteriser", "rays, hierarchy") + scaled);
    say_times(chapter, curves, "triangles");
}

/// Figure 1.6: a race for each size of the image, up to twice the side.
inline void race_by_pixels(course::Chapter& chapter, int side) {
    constexpr int level = 32;
    const auto    shown = course::counted(std::ssize(teapot(level).faces), "triangle");
    auto          chart =
        chapter.chart("pixels", fmt::format("One image of {}, one thread", shown), race_axes("pixels"));
    Curves           curves;
    std::vector<int> edges{16};
    while (edges.back() < 2 * side) edges.push_back(2 * edges.back());
    const auto cost = [](int edge) { return 1'000'000 + edge * edge; };  // measured once
    int        all  = 0;
    for (const int edge : edges) all += cost(edge);
    course::Progress progress("racing by pixels", all);
    for (const int edge : edges) {
        const Race race(level, edge);
        add(chart, curves, race, chapter.options(), double(race.pixels()));
        progress.tick(cost(edge));
    }
    chart.caption(mark_crossing(chart, curves, "rays, hierarchy", "rasteriser") + scaled);
    say_times(chapter, curves, "pixels");
}

}  // namespace sr
