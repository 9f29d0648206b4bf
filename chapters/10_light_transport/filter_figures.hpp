#pragma once
/// @file filter_figures.hpp
/// Section 10.8: what a pixel sees.

#include <fmt/format.h>

#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

#include "course/chapter.hpp"
#include "course/claims.hpp"
#include "filter_response.hpp"
#include "zone_plate.hpp"

namespace sr {

inline void render_zone_plates(course::Chapter& chapter) {
    const int           size    = chapter.options().size;
    const std::uint32_t samples = chapter.options().quality == course::Quality::draft ? 16 : 256;
    for (const auto& [name, title, caption, filter] :
         {std::tuple{"middle", "In the middle", "One sample in the middle of each pixel.",
                     std::optional<PixelFilter>{}},
          {"box", "Box", "The mean over the pixel.", PixelFilter::box},
          {"tent", "Tent", "Weighted, up to the neighbours' middles.", PixelFilter::tent},
          {"gaussian", "Gaussian", "Standard deviation 0.5 pixel, out to 2.", PixelFilter::gaussian}})
        chapter.render(std::string("rings_") + name, title, caption,
                       zone_plate_through(filter, size, samples, chapter.options().threads));
}

inline void chart_filter_responses(course::Chapter& chapter) {
    auto chart = chapter.chart("responses", "What filters leave of a wave",
                               course::with_error({.x = "waves per pixel $f$", .y = "height that is left"}));
    for (const auto& [name, filter, ink] : {std::tuple{"box", PixelFilter::box, course::Ink::blue},
                                            {"tent", PixelFilter::tent, course::Ink::vermilion},
                                            {"Gaussian", PixelFilter::gaussian, course::Ink::green}}) {
        for (int i = 0; i <= 80; ++i) chart.add(name, i / 40.0, Estimate{filter_response(filter, i / 40.0)});
        for (int i = 0; i <= 20; ++i)
            chart.add("measured", i / 10.0, measured_response<RandomPoint>(filter, i / 10.0, 4096));
        chart.as_line(name);
        chart.in_ink(name, ink);
    }
    chart.as_points("measured");
    chart.in_ink("measured", course::Ink::grey);
    chart.mark_x(0.5, "finest that pixels can show");
    chart.caption(
        "Lines are (10.24), dots means of 4096 random samples with standard errors. What is left beyond 0.5 "
        "comes "
        "back as a wave that is not there.");
}

/// What the text says of waves that pixels show as they are, and of those that they can't.
inline void claim_filter_responses(course::Chapter& chapter) {
    const course::Claims claim{chapter, "10.8"};
    course::Rows         table{{"waves per pixel", "box", "tent", "Gaussian"}};
    for (const auto& [f, box, tent, gaussian] : {std::tuple{0.25, 0.900, 0.811, 0.735},
                                                 {0.5, 0.637, 0.405, 0.291},
                                                 {0.9, 0.109, 0.012, 0.018},
                                                 {1.5, -0.212, 0.045, 0.0}}) {
        std::vector<course::Cell> row{f};
        for (const auto& [name, filter, printed] : {std::tuple{"box", PixelFilter::box, box},
                                                    {"tent", PixelFilter::tent, tent},
                                                    {"Gaussian", PixelFilter::gaussian, gaussian}}) {
            // Sobol's points err by less than half of the last digit here
            const double left = measured_response<SobolPoint>(filter, f, 1 << 16).value;
            claim(fmt::format("{}: height that is left of {} waves per pixel", name, f), std::abs(printed),
                  printed < 0 ? -left : left, 5e-4);
            chapter.claim_at_most(fmt::format("10.8 {}: that, off (10.24), {} waves per pixel", name, f),
                                  std::abs(left - filter_response(filter, f)), 5e-4);
            row.emplace_back(left);
        }
        table.add(row);
    }
    chapter.say(table);
}

}  // namespace sr
