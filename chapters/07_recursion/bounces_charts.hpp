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
#include "statistics/estimate.hpp"

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

/// The rays for each radius, and radii of the balls [length units].
inline constexpr int             rays_inside = 20'000;
inline const std::vector<double> ball_radii{1e-5, 1e-4, 1e-3, 1e-2, 1e-1, 1, 1e1, 1e2, 1e3, 1e4, 1e5};

/// The share of rays that go astray, with its standard error.
inline void chart_inside(course::Chart chart, int threads) {
    const auto add = [&](const std::string& name, const auto& depart) {
        for (const double radius : ball_radii) {
            const int lost = count_inside(float(radius), rays_inside, threads, depart).astray;
            chart.add(name, radius, percent(share(lost, rays_inside)));
        }
    };
    add("fixed epsilon, $10^{-4}$", leave_by_fixed_epsilon);
    add("error bound", leave_by_error_bound);
}

}  // namespace sr
