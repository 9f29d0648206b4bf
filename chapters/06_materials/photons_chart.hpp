#pragma once
/// @file photons_chart.hpp

#include <cmath>

#include "compressed_light.hpp"
#include "course/chapter.hpp"
#include "fresnel_charts.hpp"

namespace sr {

/// Radiance in glass under a sky of 1: photons that were counted, and what a camera's ray says.
inline void chart_photons(course::Chapter& chapter, const Dielectric<double>& glass,
                          const CountedRadiance& counted) {
    const std::string x = "angle to the normal, in the glass [deg]", y = "radiance [that of the sky]";
    auto       chart = chapter.chart("radiance_in_glass", "A sky of radiance 1, seen from within glass",
                                     {.x       = x,
                                      .y       = y,
                                      .columns = {.headers = {"series", x, y, "standard error"},
                                                  .series  = "series",
                                                  .x       = x,
                                                  .y       = y,
                                                  .error   = "standard error"}});
    const auto bands = counted.L.size();
    for (std::size_t band = 0; band < bands; ++band) {
        const double theta = degrees(std::asin(std::sqrt((double(band) + 0.5) / double(bands))));
        if (theta < 60) chart.add("photons, counted", theta, counted.L[band], {counted.se[band]});
    }
    for (const double theta : angles_from_inside(58))
        chart.add("weight of a camera's ray", theta, seen_from_inside(glass, theta), {0.0});
    chart.as_points("photons, counted");
    chart.as_line("weight of a camera's ray");
    chart.caption(
        "Each dot is the mean over a band. "
        "Photons are not scaled, and yet fill the cone of 41.8 degrees with $(1 - R)\\,n^2$: what a camera's "
        "ray is "
        "scaled by.");
}

}  // namespace sr
