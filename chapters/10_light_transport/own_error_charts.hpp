#pragma once
/// @file own_error_charts.hpp
/// Section 10.10: what a picture says of its error, and what it is.

#include <fmt/format.h>

#include <cmath>
#include <memory>
#include <numbers>
#include <string>
#include <tuple>
#include <vector>

#include "course/chapter.hpp"
#include "course/claims.hpp"
#include "requested_error.hpp"
#include "stated_error.hpp"

namespace sr {

/// How far pixels lie from the truth, in standard errors that they state themselves.
inline void chart_deviations(course::Chapter& chapter, const std::vector<double>& deviations) {
    auto chart = chapter.chart(
        "deviations", "How far pixels are from the truth",
        course::with_error({.x = "error / standard error that the pixel states", .y = "density"}));
    constexpr double bin = 0.25, reach = 6;
    for (double from = -reach; from < reach; from += bin) {
        int count = 0;
        for (const double d : deviations) count += from <= d && d < from + bin ? 1 : 0;
        const auto part = share(count, deviations.size());
        chart.add("measured", from + bin / 2, Estimate{part.value / bin, part.error / bin});
    }
    for (double t = -reach; t <= reach; t += 0.1) {
        chart.add("Student", t, Estimate{student_density(t, 3)});
        chart.add("normal", t, Estimate{std::exp(-t * t / 2) / std::sqrt(2 * std::numbers::pi)});
    }
    chart.as_points("measured");
    for (const auto* name : {"Student", "normal"}) chart.as_line(name);
    chart.caption(fmt::format(
        "Of pictures of the box, four passes of 4 samples each. Student's distribution has 3 degrees of "
        "freedom. {:.0f} % of the pixels are left of all this.",
        100 * outside(deviations, -reach, reach).below));
}

/// Stated and reached errors by few passes and by many. Tolerances are four standard errors or more.
inline void claim_stated_errors(course::Chapter& chapter, const ErrorRace& race) {
    const course::Claims claim{chapter, "10.10"};
    const TileLoop       loop{.threads = chapter.options().threads};
    course::Rows         table{
        {"passes", "stated error / error", "standard error", "2 too dark [%]", "2 too bright [%]"}};
    for (const auto& [passes, pictures, dark, bright, tolerance] :
         {std::tuple{2, 16, 25, 8, 2.0}, {4, 8, 17, 2, 2.0}, {16, 4, 9, 1, 2.0}}) {
        const auto   all   = stated_errors(race, passes, pictures, loop);
        const double ratio = std::sqrt(all.stated.mean() / all.reached.mean());
        const double error = ratio / 2 *
                             std::hypot(all.stated.standard_error() / all.stated.mean(),
                                        all.reached.standard_error() / all.reached.mean());
        const auto [below, above] = outside(all.deviations, -2, 2);
        table.add({passes, ratio, error, 100 * below, 100 * above});
        const auto which = fmt::format("{} passes: ", passes);
        claim(which + "stated error over the error, to 0.08", 1, ratio, 0.08);
        claim(which + "pixels too dark by two of their standard errors [%]", dark, 100 * below, tolerance);
        claim(which + "pixels too bright by as many [%]", bright, 100 * above, tolerance);
        if (passes == 4) chart_deviations(chapter, all.deviations);
    }
    chapter.say(table);
}

/// What the text says of one way to stop, and how sure it is of that: four standard errors or more.
struct PrintedRequest {
    double      asked;
    std::string way;
    Stopping    stopping;
    int         pictures;
    double      reached, light, samples;
    double      reached_to, light_to, samples_to;
};

/// Errors that were asked for, and what came of it.
inline void claim_requested_errors(course::Chapter& chapter, const ErrorRace& race) {
    const course::Claims claim{chapter, "10.10"};
    const TileLoop       loop{.threads = chapter.options().threads};
    course::Rows         table{
        {"asked", "way", "reached / asked", "standard error", "light", "standard error", "samples"}};
    auto progress = std::make_unique<course::Progress>("asking for errors", 5);
    for (const auto& printed :
         {PrintedRequest{0.1, "all alike", Stopping::all_alike, 4, 0.97, 1, 72, 0.08, 0.01, 8},
          {0.1, "by a pilot", Stopping::by_a_pilot, 4, 0.99, 1, 76, 0.08, 0.01, 8},
          {0.1, "each alone", Stopping::each_alone, 4, 1.67, 0.95, 43, 0.2, 0.02, 5},
          {0.05, "all alike", Stopping::all_alike, 2, 0.99, 1, 276, 0.08, 0.01, 30},
          {0.05, "by a pilot", Stopping::by_a_pilot, 2, 0.97, 1, 252, 0.08, 0.01, 30}}) {
        const auto   all = RequestedError(race, printed.asked, loop).run(printed.stopping, printed.pictures);
        const double reached = std::sqrt(all.squared_errors.mean());
        progress->tick();
        table.add({printed.asked, printed.way, reached, all.squared_errors.standard_error() / (2 * reached),
                   all.light.mean(), all.light.standard_error(), all.samples.mean()});
        const auto which = fmt::format("{}, {}: ", printed.asked, printed.way);
        claim(fmt::format("{}reached over asked, to {}", which, printed.reached_to), printed.reached, reached,
              printed.reached_to);
        claim(fmt::format("{}light over that of the scene, to {}", which, printed.light_to), printed.light,
              all.light.mean(), printed.light_to);
        claim(which + "samples", printed.samples, all.samples.mean(), printed.samples_to);
    }
    progress.reset();  // its line ends before the table
    chapter.say(table);
}

}  // namespace sr
