#pragma once
/// @file cosine_law_chart.hpp
/// Figure 5.10: a facet that is turned in the sunlight.

#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "course/chapter.hpp"
#include "math/degrees.hpp"
#include "math/extremes.hpp"
#include "tilted_facet.hpp"

namespace sr {

inline void claim_cosine_law(course::Chapter& chapter) {
    course::Rows table{{"tilt [deg]", "irradiance, counted", "standard error", "cosine"}};
    double       largest = 0, farthest = 0;
    for (const auto& [tilt, expected] : {std::pair{0, 1.002}, {30, 0.869}, {60, 0.5}, {80, 0.174}}) {
        const auto E = relative_irradiance(radians(tilt), {chapter.options().threads, 1 << 14, tilt});
        table.add({tilt, E.mean(), E.standard_error(), std::cos(radians(tilt))});
        chapter.claim(fmt::format("5.5 irradiance at {} degrees, counted", tilt),
                      {.expected = expected, .measured = E.mean(), .tolerance = 4 * E.standard_error()});
        largest  = max_or_nan(largest, E.standard_error());
        farthest = max_or_nan(farthest, std::abs(E.mean() - std::cos(radians(tilt))) / E.standard_error());
    }
    chapter.claim_at_most("5.5 the largest standard error of what was counted", largest, 0.0016);
    chapter.claim_at_most("5.5 from the cosine, 1, 0.866, 0.5, 0.174, in standard errors", farthest, 3);
    chapter.say(table);
}

inline void chart_cosine_law(course::Chapter& chapter) {
    auto chart = chapter.chart(
        "cosine_law", "Sunlight on a facet that is turned",
        axes_with_error("angle between normal and light [deg]", "relative to facing the light"));
    for (int tilt = 0; tilt <= 84; tilt += 4) add(chart, "cosine", tilt, std::cos(radians(tilt)));
    for (int tilt = 2; tilt <= 86; tilt += 4) {
        const double cosine = std::cos(radians(tilt));
        const auto   E      = relative_irradiance(radians(tilt), {chapter.options().threads, 1 << 11, tilt});
        add(chart, "irradiance, counted", tilt, E.mean(), E.standard_error());
        add(chart, "irradiance / cosine: radiance", tilt, E.mean() / cosine, E.standard_error() / cosine);
    }
    chart.caption("131 072 rays of sunlight for each point; those that the facet catches are counted.");
    claim_cosine_law(chapter);
}

}  // namespace sr
