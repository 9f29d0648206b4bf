#pragma once
/// @file quality_chart.hpp
/// The chart of section 7.5: the recipes' errors against their times.

#include <string>
#include <vector>

#include "course/chapter.hpp"
#include "quality.hpp"

namespace sr {

/// The names of the curves.
inline const std::string by_depth = "all branches";
inline const std::string cut_off  = "cut off";
inline const std::string drawn    = "one branch at random";

[[nodiscard]] inline std::vector<Recipe> recipes() {
    std::vector<Recipe> all;
    for (const int depth : {1, 2, 3, 4, 5, 6, 8, 12, 16, 24, 32})
        all.push_back({by_depth, double(depth), {.depth = depth}});
    for (const float share : {0.1F, 0.03F, 0.01F, 0.003F, 0.001F, 1e-4F})
        all.push_back({cut_off, double(share), {.depth = 64, .cut_off = share}});
    for (const int trees : {1, 4, 16})
        all.push_back({drawn, double(trees), {.depth = 64, .branching = Branching::random}, trees});
    return all;
}

/// Errors in percent, and times on one thread, of all recipes.
inline void chart_quality(course::Chart chart, const SceneView& view, const course::Options& options) {
    const int                 repeats = options.quality == course::Quality::draft ? 1 : 7;
    const Judge               judge(view, options.threads);
    std::vector<course::Work> work;
    const auto                all = recipes();
    course::Progress          progress("rendering by all recipes", int(all.size()) * (repeats + 1));
    for (const auto& recipe : all)
        work.push_back({recipe.name, [&] {
                            (void)judge.shown(recipe, 1);
                            progress.tick();
                        }});
    const auto timings = course::measure(work, repeats);
    for (std::size_t i = 0; i < all.size(); ++i) {
        const auto [error, se] = judge.error(all[i]);
        progress.tick();
        chart.row({all[i].name, all[i].effort, timings[i].seconds, 100 * error, 100 * se});
    }
}

[[nodiscard]] inline course::Axes quality_axes() {
    course::Axes axes{
        .x = "time for the picture, one thread [s]", .y = "relative RMSE [%]", .log = course::axis::xy};
    axes.columns       = course::speed_accuracy();
    axes.columns.x     = "seconds";
    axes.columns.y     = "error";
    axes.columns.error = "error_se";
    return axes;
}

}  // namespace sr
