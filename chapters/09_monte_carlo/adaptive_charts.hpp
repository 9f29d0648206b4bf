#pragma once
/// @file adaptive_charts.hpp
/// Section 9.9: samples where they are needed, and when to stop.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <tuple>
#include <vector>

#include "adaptive_picture.hpp"
#include "course/claims.hpp"
#include "repeated.hpp"
#include "sample_map.hpp"
#include "stopping.hpp"
#include "strata.hpp"

namespace sr {

/// The table of allocations: 1024 samples in 16 strata.
inline void claim_strata(course::Chapter& chapter) {
    const course::Claims claim{chapter, "9.9"};
    const int            total = 1024;
    const double         even  = variance_in_strata(std::vector<int>(strata, total / strata));
    const double         best  = variance_in_strata(allocated(deviations_in_strata(), total, 1));
    claim("strata: variance, even [1e-7]", 8.77, 1e7 * even, 5e-3);
    claim("strata: variance, by sigma [1e-7]", 3.19, 1e7 * best, 5e-3);
    claim("strata: gain, by sigma", 2.75, even / best, 5e-3);
    course::Rows table{{"pilot", "gain", "standard error"}};
    for (const auto& [pilot, gain, error] :
         {std::tuple{2, 0.89, 0.03}, {4, 2.27, 0.05}, {8, 2.32, 0.05}, {16, 2.13, 0.05}, {32, 1.35, 0.03}}) {
        const auto squares =
            squared_errors(4096, chapter.options().threads, 1.0 / 6, [first = pilot](std::uint64_t repeat) {
                Rng rng{901, std::int64_t(repeat), first, 0};
                return estimate_in_two_passes(first, total, rng);
            });
        const double seen       = even / squares.mean(),
                     seen_error = seen * squares.standard_error() / squares.mean();
        table.add({pilot, seen, seen_error});
        claim(fmt::format("strata: gain, pilot of {}", pilot), gain, seen, 5e-3);
        claim(fmt::format("strata: its standard error, pilot of {}", pilot), error, seen_error, 5e-3);
    }
    chapter.say(table);
}

/// The picture by even and by adaptive samples, and the map of these.
inline void render_adaptive(course::Chapter& chapter) {
    const int size = std::max(chapter.options().size / 2, 16), threads = chapter.options().threads;
    const std::vector<int> even(std::size_t(size) * std::size_t(size), samples_of_pixel),
        counts         = counts_by_pilot(size, threads);
    const auto picture = [&](const auto& values, double scale, const auto& value_of) {
        Image<Spectrum> film(size, size);
        for (std::size_t i = 0; i < values.size(); ++i) {
            const auto grey  = float(scale * value_of(values[i]));
            film.pixels()[i] = {grey, grey, grey};
        }
        return film;
    };
    const auto mean = [](const Running& of) { return of.mean(); };
    chapter.render("shadows_even", "Shadows of three plates",
                   fmt::format("{} samples in each pixel.", samples_of_pixel),
                   picture(sample_floor(size, even, 2, threads), 3.5, mean));
    chapter.render("shadows_adaptive", "The same, adaptively",
                   "As many, where a pilot saw that they are needed.",
                   picture(sample_floor(size, counts, 3, threads), 3.5, mean));
    chapter.render("shadows_counts", "Samples of each pixel",
                   "Black is 0, white 64; the scale has a notch every 16.", map_of_samples(size, counts));
}

/// What the text says of them, at a size of its own.
inline void claim_adaptive(course::Chapter& chapter) {
    const int              size = 128, threads = chapter.options().threads;
    const std::vector<int> even(std::size_t(size) * std::size_t(size), samples_of_pixel);
    const double           evenly = relative_error(size, sample_floor(size, even, 2, threads));
    const double           adaptively =
        relative_error(size, sample_floor(size, counts_by_pilot(size, threads), 3, threads));
    const course::Claims claim{chapter, "9.9"};
    claim("shadows: relative error, even [%]", 6.02, 100 * evenly, 5e-3);
    claim("shadows: relative error, adaptive [%]", 4.29, 100 * adaptively, 5e-3);
    const std::vector<int> many(even.size(), 64);
    claim("shadows: gain that is promised", 3.35, promised_gain(sample_floor(size, many, 4, threads)), 5e-3);
    claim("shadows: gain in samples", 1.97, square(evenly / adaptively), 5e-3);
}

inline constexpr StoppingRule by_its_samples{.least = 16, .tolerance = 0.01, .error = error_of_samples},
    never_zero{.least = 16, .tolerance = 0.01, .error = error_never_zero};

/// Means and errors of estimates that stop by themselves, exactly and measured.
inline void chart_stopping(course::Chapter& chapter) {
    auto means = chapter.chart(
        "stopping", "Stopping when the estimated error is 0.01: the mean",
        course::with_error(
            {.x = "probability $p$ of a hit", .y = "mean of the estimates / $p$", .log = course::axis::x}));
    auto errors = chapter.chart(
        "stopping_error", "Stopping when the estimated error is 0.01: the error",
        {.x = "probability $p$ of a hit", .y = "error, root mean square / 0.01", .log = course::axis::x});
    for (int i = -24; i <= -3; ++i) {
        const double p = std::pow(10, i / 8.0);
        for (const auto& [name, end] : {std::tuple{"error of the samples", stopped(by_its_samples, p)},
                                        {"error never 0", stopped(never_zero, p)},
                                        {"decided by a pilot", decided_by_pilot(never_zero, p)}}) {
            means.add(name, p, Estimate{end.mean / p});
            errors.add(name, p, end.rms / never_zero.tolerance);
        }
    }
    for (int i = -20; i <= -4; i += 4) {
        const double p    = std::pow(10, i / 8.0);
        const auto   seen = [&](int stream, const auto& run) {
            Running of;
            for (const double value : repeated(1 << 13, chapter.options().threads, [&](std::uint64_t repeat) {
                     Rng rng{902, std::int64_t(repeat), i, stream};
                     return run(rng);
                 }))
                of.add(value / p);
            means.add("measured", p, Estimate{of.mean(), of.standard_error()});
        };
        seen(1, [&](Rng& rng) { return run_until_stopped(by_its_samples, p, rng); });
        seen(2, [&](Rng& rng) { return run_until_stopped(never_zero, p, rng); });
        seen(3, [&](Rng& rng) { return run_by_pilot(never_zero, p, rng); });
    }
    for (auto& chart : {means, errors})
        for (const auto* name : {"error of the samples", "error never 0", "decided by a pilot"})
            course::Chart(chart).as_line(name);
    means.as_points("measured");
    means.in_ink("measured", course::Ink::grey);
    means.caption("Lines are exact; dots are means of 8192 runs.");
    errors.caption("What was promised is 1.");
}

/// The table of p = 0.05.
inline void claim_stopping(course::Chapter& chapter) {
    const course::Claims claim{chapter, "9.9"};
    const double         p = 0.05;
    for (const auto& [name, end, mean, rms, samples] :
         {std::tuple{"by the samples", stopped(by_its_samples, p), 0.547, 3.42, 268},
          {"never 0", stopped(never_zero, p), 0.951, 1.19, 471},
          {"pilot", decided_by_pilot(never_zero, p), 1.0, 0.80, 893}}) {
        claim(fmt::format("p = 0.05, {}: mean over p", name), mean, end.mean / p, 5e-4);
        claim(fmt::format("p = 0.05, {}: error over 0.01", name), rms, end.rms / 0.01, 5e-3);
        claim(fmt::format("p = 0.05, {}: samples", name), samples, end.samples, 0.5);
    }
    claim("p = 0.05, pilot: samples that it asks for", 877,
          decided_by_pilot(never_zero, p).samples - never_zero.least, 0.5);
    claim("p = 0.05: stopped at 0 [%]", 44, 100 * stopped(by_its_samples, p).misses, 0.5);
}

}  // namespace sr
