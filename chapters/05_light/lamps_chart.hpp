#pragma once
/// @file lamps_chart.hpp
/// Section 5.8: two lamps, six ways to add them up.

#include <fmt/format.h>

#include <cstddef>
#include <string>

#include "course/chapter.hpp"
#include "lamp_methods.hpp"
#include "lamps.hpp"
#include "near_lamp_chart.hpp"

namespace sr {

/// A chart of error against time for one of the lamps.
[[nodiscard]] inline course::Chart lamp_chart(course::Chapter& chapter, const std::string& name,
                                              const std::string& title) {
    return chapter.chart(name, title,
                         {.x       = "time for one receiver [s]",
                          .y       = "relative error, root mean square",
                          .log     = course::axis::xy,
                          .columns = course::speed_accuracy()});
}

/// How fast one method's error falls: the power of the number of samples.
inline void claim_slope(course::Chapter& chapter, const std::string& lamp, const LampRace& race,
                        std::size_t method, double expected, double tolerance) {
    const auto slope = race.slope(method);
    chapter.say(fmt::format("{}, {}: power {:.2f} +- {:.2f}", lamp, lamp_methods[method].name, -slope.value,
                            slope.standard_error));
    chapter.claim(
        fmt::format("5.8 {}, {}: power with which the error falls", lamp, lamp_methods[method].name),
        {.expected = expected, .measured = -slope.value, .tolerance = tolerance});
}

/// Figures 5.18 and 5.19.
inline void speed_against_accuracy(course::Chapter& chapter) {
    chapter.section("5.8 Speed against accuracy");
    constexpr int receivers      = 128;
    const int     repeats        = chapter.options().quality == course::Quality::draft ? 2 : 7;
    auto          disk_chart     = lamp_chart(chapter, "disk_lamp", "A disk, seen whole");
    auto          occluded_chart = lamp_chart(chapter, "occluded_lamp", "A square, a disk before it");
    LampRace      disk(disk_chart, repeats), occluded(occluded_chart, repeats);
    disk.run(receivers_below_a_disk(receivers, 1.5));
    occluded.run(receivers_below_a_square(receivers, 0.35));

    disk_chart.caption(
        "The root of the mean square over 128 receivers, with standard errors; 4 to 4096 points.");
    occluded_chart.caption(
        "The same for 128 receivers below a square that is partly hidden: no method is exact any more.");

    constexpr std::size_t midpoint = 0, gauss = 1, area = 2, stratified = 3, angle = 4, angle_stratified = 5;
    claim_slope(chapter, "disk", disk, midpoint, 1, 0.05);
    claim_slope(chapter, "disk", disk, area, 0.5, 0.15);
    claim_slope(chapter, "disk", disk, stratified, 1, 0.15);
    chapter.claim_at_most("5.8 disk, Gauss-Legendre: relative error of 64 x 64 points",
                          disk.error(gauss, 64).rms, 1e-13);
    claim_slope(chapter, "square", occluded, midpoint, 0.85, 0.005);  // nothing random in it
    chapter.claim(
        "5.8 square, midpoint: standard error of that power",
        {.expected = 0.07, .measured = occluded.slope(midpoint).standard_error, .tolerance = 0.005});
    claim_slope(chapter, "square", occluded, gauss, 0.75, 0.2);
    claim_slope(chapter, "square", occluded, area, 0.5, 0.2);
    claim_slope(chapter, "square", occluded, stratified, 0.75, 0.1);
    claim_slope(chapter, "square", occluded, angle, 0.5, 0.2);
    claim_slope(chapter, "square", occluded, angle_stratified, 0.75, 0.1);
    chart_near_lamp(chapter);
}

}  // namespace sr
