#pragma once
/// @file leak_chart.hpp
/// Time against leaks, and against the error of t.

#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

#include "course/chapter.hpp"
#include "race.hpp"

namespace sr {

[[nodiscard]] inline course::Axes race_axes(const std::string& error, course::axis log) {
    course::Axes axes{.x = "time for a test [ns]", .y = error, .log = log};
    axes.columns       = course::speed_accuracy({"precision", "place", "leaks", "t_error", "ns_per_test"});
    axes.columns.x     = "ns_per_test";
    axes.columns.y     = "error";
    axes.columns.error = "error_se";
    return axes;
}

/// Attacks the sphere's edges with these rays, times all methods, and fills both charts, a row for each method,
/// precision and place. A test's time is the same in all places.
inline void race(course::Chart leaks, course::Chart errors, const Target& sphere, const Image<Aim>& aims,
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
        for (const auto& place : placements) {
            const auto   rates = leak_rates<T>(sphere, place, aims, {.threads = options.threads});
            const auto   wrong = t_errors<T>(place);
            const double n     = double(aims.pixels().size());
            for (std::size_t i = 0; i < method_count; ++i) {
                const auto&  timing = timings[first + i];
                const double share = rates[i] / 100, se = std::sqrt(share * (1 - share) / n);
                const auto   row = [&](double error, double error_se) {
                    return std::vector<course::Cell>{
                        timing.name,       tests,      timing.median, error,    error_se,
                        precision_name<T>, place.name, share,         wrong[i], timing.median / tests * 1e9};
                };
                leaks.row(row(share, se));
                errors.row(row(wrong[i], 0));
            }
        }
    };
    add(0.0F, 0);
    add(0.0, method_count);
    if (!(kept > 0)) throw std::logic_error("no ray of the race hit the sphere");
}

}  // namespace sr
