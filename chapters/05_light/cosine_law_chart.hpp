#pragma once
/// @file cosine_law_chart.hpp
/// Figure 5.10: a facet that is turned in the sunlight.

#include <fmt/format.h>

#include <cmath>

#include "course/chapter.hpp"
#include "math/degrees.hpp"
#include "math/extremes.hpp"
#include "tilted_facet.hpp"

namespace sr {

inline void claim_cosine_law(course::Chapter& chapter) {
    course::Rows table{{"tilt [deg]", "caught, per area", "standard error", "cosine"}};
    double       farthest = 0;
    struct Row {
        int     tilt;
        Printed caught, error;
    };
    for (const auto& [tilt, caught, error] :
         {Row{0, {1.0022, 1e-4}, {0.0016, 1e-4}}, Row{30, {0.8689, 1e-4}, {0.0015, 1e-4}},
          Row{60, {0.5005, 1e-4}, {0.0012, 1e-4}}, Row{80, {0.1737, 1e-4}, {0.0007, 1e-4}}}) {
        const double cosine = std::cos(radians(tilt));
        const auto   E =
            estimate(relative_irradiance(radians(tilt), {chapter.options().threads, 1 << 14, tilt}));
        table.add({tilt, E.value, E.error, cosine});
        claim_estimate(chapter, fmt::format("5.5 caught at {} degrees, per area", tilt), E, caught, error);
        farthest = max_or_nan(farthest, std::abs(E.value - cosine) / E.error);
    }
    chapter.claim_at_most("5.5 from the cosine, 1, 0.866, 0.5, 0.1736, in standard errors", farthest, 3);
    chapter.say(table);
}

inline void chart_cosine_law(course::Chapter& chapter) {
    auto chart = chapter.chart("cosine_law", "Sunlight on a facet that is turned",
                               course::with_error({.x = "angle between normal and light [deg]",
                                                   .y = "caught, per area, relative to the square"}));
    for (int tilt = 0; tilt <= 90; tilt += 2) chart.add("cosine", tilt, Estimate{std::cos(radians(tilt))});
    for (int tilt = 2; tilt <= 86; tilt += 4) {
        const double cosine = std::cos(radians(tilt));
        const auto   E =
            estimate(relative_irradiance(radians(tilt), {chapter.options().threads, 1 << 11, tilt}));
        chart.add("irradiance, counted", tilt, E);
        chart.add("irradiance / cosine: radiance", tilt, Estimate{E.value / cosine, E.error / cosine});
    }
    chart.as_line("cosine");
    chart.as_points("irradiance, counted");
    chart.as_points("irradiance / cosine: radiance");
    chart.caption("131 072 rays of sunlight for each point; those that the facet catches are counted.");
    claim_cosine_law(chapter);
}

}  // namespace sr
