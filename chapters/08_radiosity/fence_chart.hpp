#pragma once
/// @file fence_chart.hpp
/// Section 8.9: shadows finer than the mesh.

#include <fmt/format.h>

#include <tuple>

#include "course/chapter.hpp"
#include "fence.hpp"

namespace sr {

/// The floor from above.
inline void render_fence(course::Chapter& chapter, int n, const Visibility& visibility) {
    const int     threads = chapter.options().threads, side = chapter.options().size;
    const Patches floor = fence_floor(n);
    const auto    B     = lit_through_fence(floor, visibility, threads);
    const auto    above = pinhole_camera<double>({0.5, 0.5, 2}, {0, 0, -1}, {0, 1, 0}, 2, 1, side, side);
    chapter.render(fmt::format("fence_{}", n), fmt::format("A fence's shadow in {} x {} patches", n, n),
                   "Eight slats, as wide as the gaps between them.",
                   picture(PatchView(floor), above, constant_radiosity(B), 2, {threads}));
}

inline void chart_fence(course::Chapter& chapter) {
    auto             chart   = chapter.chart("fence", "The shadow of a fence of eight slats",
                                             course::with_error({.x   = "patches along the floor",
                                                                 .y   = "relative error, root mean square [%]",
                                                                 .log = course::axis::xy}));
    const int        threads = chapter.options().threads;
    const Visibility visibility(fence());
    const auto       points  = points_of_the_floor();
    const auto       exact   = seen_through_fence(points, visibility, threads);
    const auto       meshes  = {1, 2, 3, 5, 7, 10, 14, 20, 28, 40, 56, 80};
    int              patches = 0;
    for (const int n : meshes) patches += n * n;
    course::Progress progress("lighting floors", patches);
    for (const int n : meshes) {
        const auto error = fence_error(n, points, exact, visibility, threads);
        chart.add("constant", n, percent(error.constant));
        chart.add("interpolated", n, percent(error.interpolated));
        progress.tick(n * n);
    }
    chart.mark_x(16, "a patch for each slat and gap");
    chart.caption(
        "Against 1600 rays for each of 400 points, with standard errors. Light straight from the lamp.");
    for (const auto& [n, error, digit] : {std::tuple{10, 94.0, 1.0}, {20, 67, 1}, {40, 42, 1}, {80, 23, 1}})
        chapter.claim(fmt::format("8.9 a fence's shadow in {} x {} patches: error [%]", n, n),
                      {error, chart.at("constant", n), digit / 2});
    chapter.claim(
        "8.9 a fence's shadow: mean of 10 x 10 patches over that of 80 x 80",
        {0.99, mean_through_fence(10, visibility, threads) / mean_through_fence(80, visibility, threads),
         0.005});
    for (const int n : {10, 80}) render_fence(chapter, n, visibility);
}

}  // namespace sr
