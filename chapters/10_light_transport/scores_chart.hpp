#pragma once
/// @file scores_chart.hpp
/// Section 10.6: how far the pixels of a known picture are from what they must be, counted.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <string>
#include <vector>

#include "course/chapter.hpp"
#include "course/claims.hpp"
#include "math/extremes.hpp"
#include "statistics/tests.hpp"
#include "vanishing_room.hpp"

namespace sr {

/// Cells of half a standard error from -3 to 3, and one at each end for all beyond.
struct ScoreCells {
    static constexpr std::size_t count = 14;
    static constexpr double      width = 0.5, first = -3;

    std::array<std::uint64_t, count> observed{};
    std::array<double, count>        expected{};

    explicit ScoreCells(const std::vector<double>& scores) {
        for (const double z : scores)
            ++observed.at(
                std::size_t(std::clamp(std::floor((z - first) / width) + 1, 0.0, double(count - 1))));
        const auto below =
            [](std::size_t edge) {  // the normal distribution's share below an edge between cells
                return std::erfc(-(first + width * double(edge)) / std::numbers::sqrt2) / 2;
            };
        for (std::size_t i = 0; i < count; ++i)
            expected[i] =
                double(scores.size()) * ((i + 1 < count ? below(i) : 1) - (i > 0 ? below(i - 1) : 0));
    }

    /// The middle of a cell.
    [[nodiscard]] static double at(std::size_t i) { return first + width * (double(i) - 0.5); }
    [[nodiscard]] ChiSquare     test() const { return chi_square_test(observed, expected); }
};

inline void chart_scores(course::Chapter& chapter) {
    constexpr int    side = 20, paths = 128;  // in a draft as well: its p-values are claimed
    const int        threads = chapter.options().threads;
    const auto       right   = scores_of_pixels(room_that_vanishes(), side, paths, threads);
    const ScoreCells cells(right), wrong(scores_of_pixels(room_that_vanishes(1.01F), side, paths, threads));
    auto             chart = chapter.chart(
                    "scores", "How far pixels are from 1, in their own standard errors",
                    course::with_error({.x = "standard errors from 1", .y = "pixels in half a standard error"}));
    for (int i = -35; i <= 35; ++i) {
        const double z = i / 10.0;
        chart.add(
            "normal distribution", z,
            Estimate{side * side * ScoreCells::width * std::exp(-z * z / 2) / std::sqrt(2 * std::numbers::pi),
                     0});
    }
    for (std::size_t i = 0; i < ScoreCells::count; ++i) {
        const auto bar = [](std::uint64_t n) {
            return Estimate{double(n), std::sqrt(double(std::max<std::uint64_t>(n, 1)))};
        };
        chart.add("pixels", ScoreCells::at(i), bar(cells.observed[i]));
        chart.add("reflectances 1 % too large", ScoreCells::at(i), bar(wrong.observed[i]));
    }
    chart.as_line("normal distribution");
    chart.as_points("pixels");
    chart.as_points("reflectances 1 % too large");
    chart.caption(
        fmt::format("{} pixels of {} paths each; the outermost dots are of all beyond.", side * side, paths));
    double farthest = 0;
    for (const double z : right) farthest = max_or_nan(farthest, std::abs(z));
    chapter.claim_at_most("10.6 the room's pixels, farthest from 1 [standard errors]", farthest, 4.5);
    // significance 10^-4; the wrong ones are refused at 10^-10
    chapter.claim_at_most("10.6 1 - p of the right pixels", 1 - cells.test().p, 0.9999);
    chapter.claim_at_most("10.6 p of pixels whose reflectances are 1 % too large", wrong.test().p, 1e-10);
}

}  // namespace sr
