#pragma once
/// @file lamps_chart.hpp
/// Section 5.8: two lamps, six ways to add them up.

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

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

/// How fast one method's error falls, as the text prints it: the power of the number of points, and its error.
struct Power {
    std::size_t method;
    double      value, error;
    double      expected;  ///< by reason, and measured to 0.1
};

/// The powers of one lamp.
inline void claim_powers(course::Chapter& chapter, const LampRace& race, const std::vector<Power>& powers) {
    course::Rows table{{"lamp", "method", "power", "standard error"}};
    for (const auto& [method, value, error, expected] : powers) {
        const auto        slope = race.slope(method);
        const Estimate    power{-slope.value, slope.standard_error};
        const std::string what = fmt::format("5.8 {}, {}: power with which the error falls", race.lamp(),
                                             lamp_methods[method].name);
        table.add({race.lamp(), lamp_methods[method].name, power.value, power.error});
        claim_estimate(chapter, what, power, {value, 0.01}, {error, 0.01});
        chapter.claim(
            what + ", by reason",
            {.expected = expected, .measured = power.value, .tolerance = std::max(0.1, 2 * power.error)});
    }
    chapter.say(table);
}

/// Figures 5.19 and 5.20.
inline void speed_against_accuracy(course::Chapter& chapter) {
    chapter.section("5.8 Speed against accuracy");
    constexpr int receivers      = 128;
    const int     repeats        = chapter.options().quality == course::Quality::draft ? 1 : 7;
    auto          disk_chart     = lamp_chart(chapter, "disk_lamp", "A disk, seen whole");
    auto          occluded_chart = lamp_chart(chapter, "occluded_lamp", "A square, a disk before it");
    LampRace      disk(disk_chart, "disk", repeats), square(occluded_chart, "square", repeats);
    disk.run(receivers_below_a_disk(receivers, 1.5));
    square.run(receivers_below_a_square(receivers, 0.35));

    disk_chart.caption(
        "The root of the mean square over 128 receivers, with standard errors; 4 to 4096 points.");
    occluded_chart.caption(
        "The same for 128 receivers below a square that is partly hidden: no method is exact any more.");

    constexpr std::size_t midpoint = 0, gauss = 1, area = 2, stratified = 3, angle = 4, angle_stratified = 5;
    claim_powers(chapter, disk,
                 {{midpoint, 1, 0, 1},
                  {area, 0.48, 0.03, 0.5},
                  {stratified, 1.03, 0.04, 1},
                  {angle, 0.46, 0.03, 0.5},
                  {angle_stratified, 0.74, 0.01, 0.75}});
    chapter.claim_at_most("5.8 disk, Gauss-Legendre: relative error of 64 x 64 points",
                          disk.error(gauss, 64).rms, 1e-13);
    claim_powers(chapter, square,
                 {{midpoint, 0.85, 0.07, 0.75},
                  {gauss, 0.76, 0.04, 0.75},
                  {area, 0.49, 0.04, 0.5},
                  {stratified, 0.75, 0.02, 0.75},
                  {angle, 0.49, 0.04, 0.5},
                  {angle_stratified, 0.74, 0.04, 0.75}});
    for (const auto& [method, error] :
         {std::pair{midpoint, 0.00101}, {gauss, 0.00174}, {stratified, 0.0017}, {angle_stratified, 0.00166}})
        chapter.claim(fmt::format("5.8 square, {}: relative error of 4096 points", lamp_methods[method].name),
                      {.expected = error, .measured = square.error(method, 64).rms, .tolerance = 5e-6});
    chart_near_lamp(chapter);
}

}  // namespace sr
