#pragma once
/// @file light_leaks.hpp
/// What a mesh does to shadows: light below a block that is shared out to all of a patch, and shadow before it.

#include <fmt/format.h>

#include <cmath>
#include <optional>
#include <string>
#include <tuple>

#include "aligned_floor.hpp"
#include "cornell_views.hpp"
#include "gather.hpp"
#include "math/extremes.hpp"

namespace sr {

/// A point of the floor between its right border and its left one, through the short block.
[[nodiscard]] inline Vector3<double> on_the_floor(double x) {
    return {x, 0, 168.5};
}
inline constexpr Interval<double> below_the_block{98.95, 272.75};  ///< x where that line is below it

/// What the floor's point gets, each patch as far as it is seen from there.
[[nodiscard]] inline std::optional<double> floor_as_gathered(const SolvedScene& box,
                                                             const Visibility& visibility, double x) {
    if (below_the_block.contains(x)) return std::nullopt;
    const Patch& floor = box.patches.shapes.front();
    return gathered({floor.surface_point(on_the_floor(x)), box.patches.reflectance.front(), {}}, box.patches,
                    box.radiosities, &visibility, 6)
        .r;
}

/// The floor's radiosity there in a solution; none where there is no floor.
[[nodiscard]] inline std::optional<double> floor_as_solved(const PatchView&   view,
                                                           const RadiosityAt& radiosity, double x) {
    const Ray<double> down{on_the_floor(x) + Vector3<double>{0, 0.5, 0}, {0, -1, 0}};
    const auto        seen = view.seen(down);
    if (!seen) return std::nullopt;
    return radiosity(*seen).r;
}

/// The figure of section 8.7: across a shadow.
inline void chart_leaks(course::Chapter& chapter, const SolvedScene& box, const SolvedScene& aligned) {
    auto             chart = chapter.chart("leaks", "Across the floor, from the green wall to the red one",
                                           {.x = "$x$ [mm]", .y = "radiosity of the floor, red [W/m$^2$]"});
    const Visibility visibility(cornell_box().mesh);
    const PatchView  view(box.patches), aligned_view(aligned.patches);
    const auto       add = [&](const std::string& name, double x, std::optional<double> B) {
        if (B)
            chart.add(name, x, *B);
        else
            chart.gap(name, x);
    };
    const auto constant = constant_radiosity(box.radiosities),
               smooth   = interpolated_radiosity(box.patches, box.at_vertices),
               cured    = interpolated_radiosity(aligned.patches, aligned.at_vertices);
    for (int i = 0; i <= 91; ++i) {
        const double x = 0.5 + 6 * i;
        add("gathered", x, floor_as_gathered(box, visibility, x));
        add("constant", x, floor_as_solved(view, constant, x));
        add("interpolated", x, floor_as_solved(view, smooth, x));
        add("interpolated, aligned", x, floor_as_solved(aligned_view, cured, x));
    }
    for (const char* curve : {"gathered", "constant", "interpolated", "interpolated, aligned"})
        chart.as_line(curve);
    chart.mark_band(below_the_block.min, below_the_block.max, "short block");
    for (const auto& [name, B, digit] : {std::tuple{"gathered", 0.7, 0.1},
                                         {"constant", 0.45, 0.01},
                                         {"interpolated", 0.39, 0.01},
                                         {"interpolated, aligned", 0.7, 0.01}})
        chapter.claim(fmt::format("8.7 the floor before the block, {}: radiosity [W/m2]", name),
                      {B, chart.at(name, 288.5), digit / 2});
    chapter.claim("8.7 the floor below the middle of the block, interpolated: radiosity [W/m2]",
                  {0.10, chart.at("interpolated", 186.5), 0.005});
    chart.caption("Below the block it is dark: all light there is a leak. Aligned: cut along the block.");
}

/// By how much the aligned mesh's radiosity jumps along a seam: between two pieces of the floor whose vertices are not
/// the same [W/m^2].
[[nodiscard]] inline double jump_at_seam(const SolvedScene& aligned) {
    const PatchView       view(aligned.patches);
    const auto            radiosity = interpolated_radiosity(aligned.patches, aligned.at_vertices);
    const Vector3<double> from{552.8, 0, 0},
        to{290, 0, 114};  // from a corner of the floor to one of the block
    const Vector3<double> aside{0.4, 0, 0.9};
    double                largest = 0;
    for (int i = 1; i < 100; ++i) {
        const auto p    = from + i / 100.0 * (to - from);
        const auto look = [&](const Vector3<double>& at) {
            const auto seen = view.seen({at + Vector3<double>{0, 1, 0}, {0, -1, 0}});
            return seen ? radiosity(*seen).r : 0;
        };
        largest = max_or_nan(largest, std::abs(look(p + 0.01 * aside) - look(p - 0.01 * aside)));
    }
    return largest;
}

/// The short block's foot from near.
[[nodiscard]] inline Camera<double> camera_at_foot(int side) {
    return camera_towards({30, 260, -120}, {120, 20, 130}, {0, 1, 0}, 0.03, side);
}

inline void show_leaks(course::Chapter& chapter, const SolvedScene& box, const SolvedScene& aligned) {
    chart_leaks(chapter, box, aligned);
    course::Progress progress("looking at a block's foot", 2 * steps_of_loop);
    const int        side = chapter.options().size;
    chapter.render("foot", "The foot of the short block", "A mesh that knows nothing of the block.",
                   CornellViews(chapter, box, progress).smooth(camera_at_foot(side)));
    chapter.render("foot_aligned", "The same, the floor cut along the block", "About as many patches.",
                   CornellViews(chapter, aligned, progress).smooth(camera_at_foot(side)));
    chapter.claim("8.7 along the floor's seam, the largest jump of the radiosity [W/m2]",
                  {0.31, jump_at_seam(aligned), 0.005});
}

}  // namespace sr
