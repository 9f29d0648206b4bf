#pragma once
/// @file error_race_charts.hpp
/// Section 10.9: error against time.

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

#include "course/chapter.hpp"
#include "course/claims.hpp"
#include "error_race.hpp"
#include "math/square.hpp"

namespace sr {

/// All these racers with all these numbers of samples, in turn.
[[nodiscard]] inline std::vector<RaceLap> run_laps(const ErrorRace& race, const std::vector<Racer>& who,
                                                   const std::vector<std::uint32_t>& samples,
                                                   course::Progress&                 progress) {
    std::vector<RaceLap> laps;
    for (const auto& racer : who)
        for (const auto n : samples) {
            laps.push_back(race.lap(racer, n));
            progress.tick();
        }
    return laps;
}

/// Seconds of one sample of each pixel, on one thread, for each racer in turn. A lap is short, so that some run
/// undisturbed even where the machine does much else.
[[nodiscard]] inline std::vector<course::Timing> time_racers(const ErrorRace& race, int repeats) {
    constexpr std::uint32_t   samples = 4;
    double                    sum = 0;  // looked at below: work whose result nobody needs is optimised away
    std::vector<course::Work> work;
    for (const auto& racer : racers)
        work.push_back({racer.name, [&] { sum += race.picture(racer, 1, samples, {}).relative_error(); }});
    auto timings = course::measure(work, repeats);
    if (!(sum > 0)) throw std::logic_error("no picture was rendered");
    for (auto& timing : timings) timing.seconds /= samples;
    return timings;
}

[[nodiscard]] inline double seconds_of_lap(const std::vector<course::Timing>& timings, const RaceLap& lap) {
    for (const auto& timing : timings)
        if (timing.name == lap.racer.name) return timing.seconds * lap.samples;
    throw std::out_of_range(lap.racer.name);
}

/// Each strategy has a colour; without roulette it is dashed.
inline void ink_racers(course::Chart chart) {
    chart.in_ink("light, no roulette", course::Ink::green);
    for (const auto* name : {"power", "power, no roulette"}) chart.in_ink(name, course::Ink::amber);
    for (const auto* name : {"light, no roulette", "power, no roulette"}) chart.as_dashed(name);
    chart.in_ink("power, random", course::Ink::black);
}

inline void chart_strategies(course::Chapter& chapter, const std::vector<RaceLap>& laps,
                             const std::vector<course::Timing>& timings) {
    auto columns = course::speed_accuracy();
    auto chart   = chapter.chart(
          "strategies", "The box by all strategies: error against time",
          {.x = "time, one thread [s]", .y = "relative RMSE", .log = course::axis::xy, .columns = columns});
    for (const auto& lap : laps)
        chart.row(
            {lap.racer.name, lap.samples, seconds_of_lap(timings, lap), lap.error.value, lap.error.error});
    chart.caption(
        "32 $\\times$ 32 pixels, lamp left out, with standard errors. Samples go up by factors of 4.");
    ink_racers(chart);
}

/// 1 / (error^2 time), over that of blind paths with as many samples: what the same time brings.
inline void chart_efficiency(course::Chapter& chapter, const std::vector<RaceLap>& laps,
                             const std::vector<course::Timing>& timings) {
    const auto cost = [&](const RaceLap& lap) {
        return square(lap.error.value) * seconds_of_lap(timings, lap);
    };
    auto chart = chapter.chart(
        "efficiency", "What the same time brings, over blind paths",
        course::with_error({.x = "samples", .y = "efficiency, blind = 1", .log = course::axis::xy}));
    const auto part = [](const RaceLap& of) { return 2 * of.error.error / of.error.value; };
    for (const auto& blind : laps) {
        if (blind.racer.name != "blind") continue;
        for (const auto& lap : laps) {
            if (lap.samples != blind.samples) continue;
            const double gain = cost(blind) / cost(lap);
            chart.add(lap.racer.name, lap.samples,
                      Estimate{gain, &lap == &blind ? 0 : gain * std::hypot(part(lap), part(blind))});
        }
    }
    ink_racers(chart);
    chart.caption("1 / (mean squared error $\\times$ time), over that of blind paths with as many samples.");
}

}  // namespace sr
