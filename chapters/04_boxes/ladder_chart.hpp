#pragma once
/// @file ladder_chart.hpp
/// The charts of the ladder: figures 4.6, 4.7 and 4.9.

#include <fmt/format.h>

#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

#include "course/chapter.hpp"
#include "course/number.hpp"
#include "ladder.hpp"

namespace sr {

/// Meshes of 2 to a million triangles: pieces of the coarsest teapot, then finer and finer ones.
[[nodiscard]] inline std::vector<Mesh<float>> ladder_meshes(bool draft) {
    std::vector<Mesh<float>> meshes;
    const auto               coarsest = convert<float>(teapot(1));
    for (const std::size_t count : {2U, 3U, 4U, 6U, 8U, 12U, 20U, 32U})
        meshes.push_back(thinned(coarsest, count));
    for (const int level : {1, 2, 4, 8, 16, 32, 64, 125}) {
        if (level <= (draft ? 16 : 125)) meshes.push_back(convert<float>(teapot(level)));
    }
    return meshes;
}

/// As in a speed/accuracy chart, with y derived from a column of its own.
[[nodiscard]] inline course::Axes ladder_axes(const std::string& y, const std::string& column) {
    course::Axes axes{.x = "triangles", .y = y, .log = course::axis::xy};
    axes.columns   = course::speed_accuracy({"triangles", "rays_per_second", "build_seconds", "rays_to_pay"});
    axes.columns.x = "triangles";
    axes.columns.y = column;
    axes.columns.error = "";
    return axes;
}

/// For the rungs among themselves: beside all triangles their curves are one.
[[nodiscard]] inline course::Axes relative_axes() {
    return {.x       = "triangles",
            .y       = "times as many rays per second",
            .log     = course::axis::x,
            .columns = {.headers = {"method", "triangles", "gain", "least"},
                        .series  = "method",
                        .x       = "triangles",
                        .y       = "gain",
                        .min     = "least",
                        .max     = "gain"}};
}

/// The rays after which a method has caught up with another one that needs no building, or less of it.
[[nodiscard]] inline double rays_to_pay(const Climb& method, const Climb& rival) {
    return (method.build_seconds - rival.build_seconds) / (rival.seconds - method.seconds);
}

/// The charts and the table of what the rungs take.
class LadderCharts {
public:
    explicit LadderCharts(course::Chapter& chapter)
        : speed_(chapter.chart("hierarchy", "Random rays at a teapot, one thread",
                               ladder_axes("rays per second", "rays_per_second"))),
          relative_(
              chapter.chart("rungs", "Rays per second, relative to the median's tree", relative_axes())),
          build_(chapter.chart("build", "Building a hierarchy, one thread",
                               ladder_axes("time to build [s]", "build_seconds"))) {
        const std::string pieces = " Below 52 triangles, pieces of the coarsest teapot.";
        speed_.caption("Lines that come from everywhere and meet the box around the mesh." + pieces);
        relative_.caption("The same lines; bars from the slowest run on." + pieces);
        build_.caption(
            "Median parts the triangles along one axis; binned counts them in bins, and swept sorts them, "
            "along "
            "each axis.");
    }

    /// @param n  triangles
    void add(std::size_t n, const Climb& climb, const Climb& median_tree, const Climb& all) {
        const bool   is_all = &climb == &all;
        const double pay    = is_all ? 0 : rays_to_pay(climb, all);
        const auto   gain   = [&](double seconds) { return median_tree.seconds / seconds; };

        const std::vector<course::Cell> row{climb.method,
                                            n,
                                            climb.seconds,
                                            climb.error,
                                            climb.error_se,
                                            n,
                                            1 / climb.seconds,
                                            climb.build_seconds,
                                            std::isfinite(pay) ? pay : 0};
        speed_.row(row);
        if (!is_all) relative_.row({climb.method, n, gain(climb.seconds), gain(climb.slowest)});
        if (!is_all && n > 3 && climb.method != "the core's choice") build_.row(row);
        table_.add({n, climb.method, climb.seconds * 1e9, climb.build_seconds * 1e3,
                    is_all    ? course::Cell("-")
                    : pay > 0 ? course::Cell(fmt::format("{:.0f}", std::ceil(pay)))
                              : course::Cell("never")});
    }

    [[nodiscard]] const course::Rows& table() const { return table_; }

private:
    course::Chart speed_, relative_, build_;
    course::Rows  table_{{"triangles", "method", "ns for a ray", "to build [ms]", "has paid after [rays]"}};
};

/// Runs all rungs on all meshes: how fast they are, what they take to build, when that has paid.
inline void climb_the_ladder(course::Chapter& chapter) {
    LadderCharts charts(chapter);
    const auto   meshes = ladder_meshes(chapter.options().quality == course::Quality::draft);
    int          cost   = 0;
    for (const auto& mesh : meshes) cost += expected_cost(mesh);
    course::Progress progress("climbing the ladder", cost);
    double           differing = 0;
    for (const auto& mesh : meshes) {
        const Ladder ladder(mesh, chapter.options());
        const auto   climbs = ladder.climb();
        for (const auto& climb : climbs) {
            charts.add(ladder.triangles(), climb, climbs.front(), climbs.back());
            differing += climb.error;
        }
        progress.tick(expected_cost(mesh));
    }
    chapter.say(charts.table());
    chapter.claim("4.7 rays that a hierarchy answers unlike all triangles do, on any rung",
                  {.measured = differing});
}

}  // namespace sr
