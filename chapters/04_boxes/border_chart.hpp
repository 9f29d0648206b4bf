#pragma once
/// @file border_chart.hpp
/// Figure 4.8: from how many triangles on a hierarchy is faster than asking all of them.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <list>
#include <stdexcept>
#include <vector>

#include "course/chapter.hpp"
#include "ladder.hpp"

namespace sr {

/// How many times as fast as asking all triangles: the quartiles of many rounds.
struct Gain {
    double lower, median, upper;
};

[[nodiscard]] inline Gain quartiles(std::vector<double> gains) {
    std::ranges::sort(gains);
    const auto at = [&](std::size_t quarter) { return gains[quarter * (gains.size() - 1) / 4]; };
    return {at(1), at(2), at(3)};
}

/// Of each rung. In each round all take turns, and the shortest time of each counts: what else the machine does can
/// only add to a time, and then to any of them.
[[nodiscard]] inline std::vector<Gain> gains(const Mesh<float>& mesh, const course::Options& options) {
    const bool                  draft = options.quality == course::Quality::draft;
    const auto                  rays  = rays_at(mesh, draft ? 500 : 2000, options.seed);
    const BruteForce<float>     all(mesh);
    std::list<Hierarchy<float>> built;
    for (const auto& rung : rungs) built.push_back(boxes_of(mesh, rung.cut));
    std::uint64_t hits  = 0;  // what nobody looks at is optimised away
    const auto    trace = [&](const auto& surfaces, double& shortest) {
        shortest = std::min(shortest, course::seconds_of([&] {
                                for (const auto& ray : rays) hits += surfaces.nearest(ray) ? 1U : 0U;
                            }));
    };
    std::vector<std::vector<double>> gains(rungs.size());
    for (int round = 0; round < (draft ? 5 : 21); ++round) {
        constexpr double    never       = std::numeric_limits<double>::infinity();
        double              all_seconds = never;
        std::vector<double> seconds(rungs.size(), never);
        for (int turn = 0; turn < (draft ? 3 : 25); ++turn) {
            trace(all, all_seconds);
            std::size_t rung = 0;
            for (const auto& hierarchy : built) trace(hierarchy, seconds[rung++]);
        }
        for (std::size_t i = 0; i < rungs.size(); ++i) gains[i].push_back(all_seconds / seconds[i]);
    }
    if (hits == 0) throw std::logic_error("no ray at the border hit its mesh");
    std::vector<Gain> result;
    for (const auto& of_rung : gains) result.push_back(quartiles(of_rung));
    return result;
}

inline void chart_border(course::Chapter& chapter) {
    auto chart = chapter.chart(
        "border", "Rays per second with a hierarchy, relative to asking all triangles",
        {.x       = "triangles",
         .y       = "times as many rays per second",
         .log     = course::axis::x,
         .columns = {.headers = {"method", "triangles", "gain", "lower_quartile", "upper_quartile"},
                     .series  = "method",
                     .x       = "triangles",
                     .y       = "gain",
                     .min     = "lower_quartile",
                     .max     = "upper_quartile"}});
    const auto coarsest = convert<float>(teapot(1));
    for (const std::size_t count : {2U, 3U, 4U, 6U, 8U, 12U, 16U, 24U, 32U, 52U}) {
        const auto of_rungs = gains(thinned(coarsest, count), chapter.options());
        for (std::size_t i = 0; i < rungs.size(); ++i)
            chart.row({rungs[i].name, count, of_rungs[i].median, of_rungs[i].lower, of_rungs[i].upper});
        chart.row({"all triangles", count, 1, 1, 1});
    }
    chart.caption(
        "Pieces of the coarsest teapot, one thread. Medians of many rounds, and bars between their "
        "quartiles.");
}

}  // namespace sr
