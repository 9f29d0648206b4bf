#pragma once
/// @file leak_chart.hpp
/// Figure 3.5: leaks against time.

#include <fmt/format.h>

#include <array>
#include <stdexcept>
#include <string>
#include <vector>

#include "course/chapter.hpp"
#include "math/extremes.hpp"
#include "race.hpp"

namespace sr {

/// Of one method in T, what became of its rays in all placements.
struct Leaks {
    Running percent;  ///< of the rays that leak, a value for each placement
    double  least = 100, most = 0;
    double  t_error = 0;  ///< the largest mean of |t - 1|

    void add(double rate, double error) {
        percent.add(rate);
        least   = min_or_nan(least, rate);
        most    = max_or_nan(most, rate);
        t_error = max_or_nan(t_error, error);
    }
};

/// Attacks the sphere's edges with these rays in all placements, by all methods.
template <std::floating_point T>
[[nodiscard]] std::array<Leaks, method_count> leaks_of(const Target& sphere, const Image<Aim>& aims,
                                                       const TileLoop& loop) {
    std::array<Leaks, method_count> leaks;
    for (const auto& place : placements) {
        const auto rates  = leak_rates<T>(sphere, place, aims, loop);
        const auto errors = t_errors<T>(place);
        for (std::size_t i = 0; i < method_count; ++i) leaks[i].add(rates[i], errors[i].mean());
    }
    return leaks;
}

/// A point for each method and precision, and a bar from its fastest run to its slowest.
[[nodiscard]] inline course::Axes race_axes() {
    course::Axes axes{.x = "rays that leak [%]", .y = "time for a test [ns]"};
    axes.columns =
        course::speed_accuracy({"point", "precision", "least", "most", "t_error", "ns", "ns_slowest"});
    axes.columns.series = "point";
    axes.columns.x      = "error";
    axes.columns.y      = "ns";
    axes.columns.error  = "";
    axes.columns.min    = "ns";
    axes.columns.max    = "ns_slowest";
    return axes;
}

/// Times all methods, and fills the chart. A test's time is the same in all places.
inline void race(course::Chart chart, const Target& sphere, const Image<Aim>& aims,
                 const course::Options& options) {
    const bool                draft = options.quality == course::Quality::draft;
    const int                 rays  = draft ? 100 : 2000;
    const auto                tests = double(rays) * double(sphere.mesh.faces.size());
    std::vector<course::Work> work;
    double                    kept = 0;  // work whose result nobody needs is optimised away
    add_work<float>(work, rays, kept);
    add_work<double>(work, rays, kept);
    const auto timings = course::measure(work, draft ? 1 : 7);

    const auto add = [&]<class T>(T, std::size_t first) {
        const auto leaks = leaks_of<T>(sphere, aims, {.threads = options.threads});
        for (std::size_t i = 0; i < method_count; ++i) {
            const auto& [name, seconds, slowest]       = timings[first + i];
            const auto [percent, least, most, t_error] = leaks[i];
            // of one placement: the rays are the same in all of them
            const double se = standard_error(percent.mean(), aims.pixels().size());
            const double ns = 1e9 / tests;
            chart.row({name, tests, seconds, percent.mean(), se,
                       fmt::format("{}, {}", name, precision_name<T>), precision_name<T>, least, most,
                       t_error, ns * seconds, ns * slowest});
        }
    };
    add(0.0F, 0);
    add(0.0, method_count);
    if (!(kept > 0)) throw std::logic_error("no ray of the race hit the sphere");
    chart.caption("Leaks: the mean of three places. Times: of the fastest run, and bars up to the slowest.");
}

}  // namespace sr
