#pragma once
/// @file box_shadow.hpp
/// Section 10.7: a line across the short block's shadow, by both methods.

#include <fmt/format.h>

#include <cstddef>
#include <vector>

#include "box_by_radiosity.hpp"
#include "course/chapter.hpp"

namespace sr {

/// Along the floor before the short block, from wall to wall.
inline void chart_box_shadow(course::Chapter& chapter, const BoxByRadiosity& box,
                             const HierarchicalSolution& solution) {
    constexpr int              steps = 110;
    std::vector<SurfaceSample> line;
    for (int i = 0; i < steps; ++i) line.push_back({{5.0 * i + 2.5, 0, 40}, {0, 1, 0}, 0});
    const int each =
        course::ByQuality{.draft = 500, .lecture = 8000, .print = 16'000}.at(chapter.options().quality);
    const int  threads  = chapter.options().threads;
    const auto paths    = box.by_paths(line, each, threads);
    const auto leaves   = BoxByRadiosity::of_leaves(line, solution),
               gathered = box.gathered(line, solution, threads);
    auto chart =
        chapter.chart("box_shadow", "A line across a shadow",
                      course::with_error({.x = "along the floor [mm]", .y = "radiosity, green [W/m$^2$]"}));
    for (std::size_t i = 0; i < line.size(); ++i) {
        const double x = line[i].position.x;
        chart.add("leaves of the mesh", x, Estimate{leaves[i].g, 0});
        chart.add("gathered from them", x, Estimate{gathered[i].g, 0});
        chart.add("paths", x, Estimate{paths[i].mean(), paths[i].standard_error()});
    }
    chart.as_line("leaves of the mesh");
    chart.as_line("gathered from them");
    chart.as_points("paths");
    chart.caption(fmt::format("{} paths for each dot, with standard errors.", each));
}

}  // namespace sr
