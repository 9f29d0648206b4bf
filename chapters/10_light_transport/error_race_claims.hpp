#pragma once
/// @file error_race_claims.hpp
/// Section 10.9: what the text says of errors at equal samples, and of rays. Of times it says nothing in numbers.

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

#include "course/chapter.hpp"
#include "course/claims.hpp"
#include "error_race.hpp"
#include "error_race_charts.hpp"
#include "statistics/slope.hpp"

namespace sr {

[[nodiscard]] inline const RaceLap& lap_of(const std::vector<RaceLap>& laps, std::string_view name,
                                           std::uint32_t samples) {
    for (const auto& lap : laps)
        if (lap.racer.name == name && lap.samples == samples) return lap;
    throw std::out_of_range(std::string(name));
}

/// Errors with 16 samples, to four standard errors.
inline void claim_errors(course::Chapter& chapter, const std::vector<RaceLap>& laps) {
    const course::Claims claim{chapter, "10.9"};
    course::Rows         table{{"paths", "relative error, 16 samples", "standard error"}};
    for (const auto& [name, printed, tolerance] : {std::tuple{"blind", 3.9, 0.5},
                                                   {"BSDF", 2.9, 0.3},
                                                   {"light", 0.24, 0.02},
                                                   {"balance", 0.25, 0.02},
                                                   {"power", 0.24, 0.02},
                                                   {"light, no roulette", 0.20, 0.02},
                                                   {"power, no roulette", 0.20, 0.02},
                                                   {"power, random", 0.30, 0.03}}) {
        const auto error = lap_of(laps, name, 16).error;
        claim(fmt::format("{}: relative error, 16 samples, to {}", name, tolerance), printed, error.value,
              tolerance);
        table.add({name, error.value, error.error});
    }
    chapter.say(table);
}

/// Powers of 1/n by which errors fall from 4 samples to 64.
inline void claim_slopes(course::Chapter& chapter, const std::vector<RaceLap>& laps) {
    const course::Claims claim{chapter, "10.9"};
    for (const auto& [name, printed, tolerance] :
         {std::tuple{"power, random", 0.49, 0.06}, {"power", 0.54, 0.06}}) {
        std::vector<double>   samples;
        std::vector<Estimate> errors;
        for (const std::uint32_t n : {4U, 16U, 64U}) {
            samples.push_back(n);
            errors.push_back(lap_of(laps, name, n).error);
        }
        const auto slope = log_log_slope(samples, errors);
        chapter.say(
            fmt::format("{}: the error falls by the power {:.3f} of the samples (standard error {:.3f})",
                        name, -slope.value, slope.standard_error));
        claim(fmt::format("{}: power by which the error falls, to {}", name, tolerance), printed,
              -slope.value, tolerance);
    }
}

/// Rays and shadow rays of a path.
inline void claim_rays_of_paths(course::Chapter& chapter, const ErrorRace& race) {
    const course::Claims claim{chapter, "10.9"};
    course::Rows         table{{"paths", "rays", "shadow rays"}};
    for (const auto& [which, rays, shadow_rays, tolerance] :
         {std::tuple{1, 3.35, 0.0, 0.06}, {4, 3.35, 1.96, 0.06}, {6, 7.05, 4.29, 0.2}}) {
        const auto&  racer = racers[std::size_t(which)];
        const auto   count = race.count(racer, 16);
        const double r     = double(count.rays) / double(count.paths),
                     s     = double(count.shadow_rays) / double(count.paths);
        claim(fmt::format("{}: rays of a path", racer.name), rays, r, tolerance);
        claim(fmt::format("{}: shadow rays of a path", racer.name), shadow_rays, s, tolerance);
        table.add({racer.name, r, s});
    }
    chapter.say(table);
}

/// What is claimed.
[[nodiscard]] inline std::vector<RaceLap> laps_of_few_samples(const ErrorRace& race) {
    course::Progress progress("racing strategies", 2 * int(racers.size()) + 2);
    auto             laps = run_laps(race, racers, {4, 16}, progress);
    for (const auto& lap : run_laps(race, {racers[4], racers.back()}, {64}, progress)) laps.push_back(lap);
    return laps;
}

/// What is charted where there is time.
[[nodiscard]] inline std::vector<RaceLap> laps_of_many_samples(int threads) {
    constexpr int    tiles = 8;  // of the reference, each worth a lap
    course::Progress progress("racing strategies on", 5 * int(racers.size()) + tiles);
    const ErrorRace  race(8192, {threads, [&](int, int) { progress.tick(); }});
    return run_laps(race, racers, {1, 4, 16, 64, 256}, progress);
}

/// All of section 10.9: claims by few samples at any quality, charts by more where there is time.
inline void race_strategies(course::Chapter& chapter, const ErrorRace& race) {
    const bool draft = chapter.options().quality == course::Quality::draft;
    auto       laps  = laps_of_few_samples(race);
    claim_errors(chapter, laps);
    claim_slopes(chapter, laps);
    claim_rays_of_paths(chapter, race);
    chapter.claim_at_most("10.9 error of the reference over the smallest error",
                          race.error_of_reference() / lap_of(laps, "power", 64).error.value, 0.2);
    if (!draft) laps = laps_of_many_samples(chapter.options().threads);
    const auto timings = time_racers(race, draft ? 5 : 101);
    chart_strategies(chapter, laps, timings);
    chart_efficiency(chapter, laps, timings);
}

}  // namespace sr
