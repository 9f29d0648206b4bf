#pragma once
/// @file scaling_chart.hpp
/// What patches cost, all pairs of them and hierarchically.

#include <fmt/format.h>

#include <string>
#include <vector>

#include "cornell_meshes.hpp"
#include "course/chapter.hpp"
#include "statistics/slope.hpp"

namespace sr {

/// How far the chart goes at each quality: draft, lecture, print.
struct ScalingRange {
    std::vector<double> sizes;   ///< of patches [mm]
    std::vector<double> bounds;  ///< of hierarchical solutions
};

inline ScalingRange scaling_range(course::Quality quality) {
    ScalingRange range{{190, 150, 105}, {0.04, 0.02, 0.01}};
    if (quality != course::Quality::draft) {
        range.sizes.insert(range.sizes.end(), {75, 53});
        range.bounds.insert(range.bounds.end(), {0.0025, 0.000625});
    }
    if (quality == course::Quality::print) {
        range.sizes.insert(range.sizes.end(), {37, 26});
        range.bounds.push_back(0.00018);
    }
    return range;
}

/// Exponent of one column against n.
inline Slope exponent(const std::vector<MeshCost>& costs, const std::string& method,
                      double MeshCost::*column) {
    std::vector<double> n, values;
    for (const auto& cost : costs) {
        if (cost.method != method) continue;
        n.push_back(double(cost.n));
        values.push_back(cost.*column);
    }
    return log_log_slope(n, values);
}

inline std::vector<MeshCost> mesh_costs(const CornellMeshes& box, const Radiosities& reference,
                                        const ScalingRange& range) {
    int steps = 0;
    for (const double size : range.sizes) {
        const auto n = int(cut(box.polygons, size).size());
        steps += n * (n - 1) / 2;
    }
    for (const double bound : range.bounds) steps += expected_links(bound);
    course::Progress      progress("timing the meshes", steps);
    std::vector<MeshCost> costs;
    for (const double size : range.sizes) costs.push_back(dense_cost(box, size, reference, progress));
    for (const double bound : range.bounds)
        costs.push_back(hierarchical_cost(box, bound, reference, progress));
    return costs;
}

/// Figures 8.34 and 8.35. The reference is gathered from the finer solution, or, where there is time, from a still
/// finer one.
inline void chart_scaling(course::Chapter& chapter, const CornellMeshes& box, const Radiosities& from_finer) {
    const auto quality = chapter.options().quality;
    const int  threads = chapter.options().threads;
    const auto reference =
        quality == course::Quality::draft ? from_finer : box.gathered(box.solution(0.0005, threads), threads);
    const auto                     costs = mesh_costs(box, reference, scaling_range(quality));
    const std::vector<std::string> columns{"method", "n", "seconds", "mebibytes", "error"};
    auto                           time =
        chapter.chart("scaling", "The Cornell box: time against patches",
                      {.x       = "patches, or leaves",
                       .y       = "time on one thread [s]",
                       .log     = course::axis::xy,
                       .columns = {.headers = columns, .series = "method", .x = "n", .y = "seconds"}});
    auto error =
        chapter.chart("error_against_time", "The same: error against time",
                      {.x       = "time on one thread [s]",
                       .y       = "relative RMS error",
                       .log     = course::axis::xy,
                       .columns = {.headers = columns, .series = "method", .x = "seconds", .y = "error"}});
    for (const auto& [method, n, seconds, mebibytes, wrong] : costs)
        for (auto* chart : {&time, &error}) chart->row({method, n, seconds, mebibytes, wrong});
    time.caption("Form factors of all pairs, and links: solving takes little of either.");
    error.caption("Errors of what is reflected, at 4000 points.");
    for (const std::string method : {"all pairs", "hierarchical"}) {
        const Slope t = exponent(costs, method, &MeshCost::seconds);
        const Slope m = exponent(costs, method, &MeshCost::mebibytes);
        chapter.say(
            fmt::format("{}: time grows with the power {:.2f} +- {:.2f} of n, memory with {:.2f} +- {:.2f}",
                        method, t.value, t.standard_error, m.value, m.standard_error));
    }
}

}  // namespace sr
