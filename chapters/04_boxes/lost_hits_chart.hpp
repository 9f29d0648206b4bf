#pragma once
/// @file lost_hits_chart.hpp
/// Figure 4.2: how many true hits boxes lose, against how far exits are lengthened.

#include <cstddef>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "aimed_at_boxes.hpp"
#include "course/chapter.hpp"
#include "scene/teapot.hpp"

namespace sr {

/// Exits are longer by 0, 1/4, 1/2 ... 3 units of 2^-23, the gap between 1 and the next float.
constexpr int                            paddings_per_unit = 4;
[[nodiscard]] inline std::vector<double> paddings_up_to_three_units() {
    std::vector<double> paddings;
    for (int i = 0; i <= 3 * paddings_per_unit; ++i) paddings.push_back(1 + i * 0x1p-23 / paddings_per_unit);
    return paddings;
}

/// A curve as far as its first 0: a longer exit loses none of the hits that a shorter one keeps.
inline void add_to_chart(course::Chart& chart, const std::string& place, const LostHits& lost) {
    for (std::size_t i = 0; i < lost.padded.size(); ++i) {
        chart.row({place, double(i) / paddings_per_unit, lost.padded[i], lost.standard_error(i)});
        if (lost.padded[i] == 0 && lost.padded.front() > 0) return;
    }
}

/// @return what was lost, by the place that rays were aimed at
inline std::map<std::string, LostHits> chart_lost_hits(course::Chapter& chapter) {
    auto chart = chapter.chart("lost_hits", "True hits of a box that are lost in float",
                               {.x       = "exit lengthened by [units of $2^{-23}$]",
                                .y       = "true hits lost [%]",
                                .log     = course::axis::y,
                                .columns = {.headers = {"series", "units", "lost_percent", "standard_error"},
                                            .series  = "series",
                                            .x       = "units",
                                            .y       = "lost_percent",
                                            .error   = "standard_error"}});
    chart.mark_x(3, "$1 + 2\\gamma_3$");
    chart.caption(
        "Rays aimed at a place of a box of side 0.01 at coordinates up to 10, and at a vertex of a triangle "
        "in "
        "its own box; bars of one standard error. A curve ends where nothing is lost any more.");

    const int                       threads  = chapter.options().threads;
    const auto                      paddings = paddings_up_to_three_units();
    std::map<std::string, LostHits> lost;
    for (const auto& [place, part] :
         {std::pair{"corner", BoxPart::corner}, {"edge", BoxPart::edge}, {"interior", BoxPart::interior}})
        lost.emplace(place, lost_hits(part, 0.01, 400'000, paddings, threads));
    lost.emplace("vertex of a teapot", lost_vertices(convert<float>(teapot(40)), paddings, threads));
    for (const auto& [place, percent] : lost) add_to_chart(chart, place, percent);
    return lost;
}

}  // namespace sr
