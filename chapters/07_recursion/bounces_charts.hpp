#pragma once
/// @file bounces_charts.hpp
/// The charts of section 7.8: directions and places after many bounces.

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "course/chapter.hpp"
#include "drift.hpp"
#include "inside_glass.hpp"
#include "math/extremes.hpp"

namespace sr {

/// The largest drift of twelve rays after each power of ten of bounces.
inline void chart_drift(course::Chart chart) {
    const std::vector<int> after{1, 10, 100, 1000, 10'000, 100'000};
    const auto             add = [&](const std::string& name, const auto& drift_of) {
        std::vector<double> worst(after.size(), 1e-9);  // an axis of powers of ten has no 0
        for (std::uint64_t seed = 0; seed < 12; ++seed) {
            const auto one = drift_of(seed);
            for (std::size_t i = 0; i < after.size(); ++i) worst[i] = max_or_nan(worst[i], std::abs(one[i]));
        }
        for (std::size_t i = 0; i < after.size(); ++i) chart.add(name, after[i], worst[i]);
    };
    add("school's, in a sphere",
        [&](std::uint64_t seed) { return drift_in_sphere(seed, after, turn_at_school); });
    add("school's, mirrors at random", [&](std::uint64_t seed) { return drift_among_mirrors(seed, after); });
    add("normalised, in a sphere",
        [&](std::uint64_t seed) { return drift_in_sphere(seed, after, turn_renormalised); });
}

/// The rays for each radius, and radii of the balls.
inline constexpr int             rays_inside = 20'000;
inline const std::vector<double> ball_radii{1e-5, 1e-4, 1e-3, 1e-2, 1e-1, 1, 1e1, 1e2, 1e3, 1e4, 1e5};

[[nodiscard]] inline course::Axes inside_axes() {
    const std::string x = "radius of the ball", y = "rays that go astray in 20 bounces [%]";
    return {.x       = x,
            .y       = y,
            .log     = course::axis::x,
            .columns = {.headers = {"series", x, y, "standard error"},
                        .series  = "series",
                        .x       = x,
                        .y       = y,
                        .error   = "standard error"}};
}

inline void chart_inside(course::Chart chart, int threads) {
    const auto add = [&](const std::string& name, const auto& depart) {
        for (const double radius : ball_radii) {
            const int    count = astray(float(radius), rays_inside, threads, depart);
            const double share = (count + 1) / (rays_inside + 2.0);  // Laplace's: 0 of n is not never
            chart.add(name, radius, 100.0 * count / rays_inside,
                      {100 * std::sqrt(share * (1 - share) / rays_inside)});
        }
    };
    add("fixed epsilon, $10^{-4}$", leave_by_fixed_epsilon);
    add("error bound", leave_by_error_bound);
}

}  // namespace sr
