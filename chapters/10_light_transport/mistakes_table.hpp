#pragma once
/// @file mistakes_table.hpp
/// Section 10.6: which known scene finds which mistake.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "course/chapter.hpp"
#include "course/claims.hpp"
#include "known_scenes.hpp"
#include "mistaken_paths.hpp"
#include "statistics/tests.hpp"

namespace sr {

/// A mistake, what the figure calls it, and the scenes that find it: x, those that can't: -, from left to right.
struct MistakeRow {
    Mistake          mistake;
    std::string_view name;
    std::string_view found;
};
inline constexpr std::array mistake_rows{
    MistakeRow{Mistake::none, "none", "------"},
    MistakeRow{Mistake::no_pi, "no $\\pi$", "xxxxxx"},
    MistakeRow{Mistake::no_cosine, "no cosine", "xxxxxx"},
    MistakeRow{Mistake::density, "density 20 % off", "xxxxxx"},
    MistakeRow{Mistake::twice, "light counted twice", "xxxxx-"},
    MistakeRow{Mistake::no_shadow, "no shadows", "--xx--"},
    MistakeRow{Mistake::two_bounces, "two bounces only", "-xx-xx"},
    MistakeRow{Mistake::wrong_directions, "wrong directions", "--x-xx"},
};

/// In standard errors. Of 48 cells without a mistake one is above 4.5 by chance in one case of 3000.
inline constexpr double found_from = 4.5;

/// How far the mean of so many paths is from what it must be, row by row [standard errors]. One without any variance
/// is known to rounding.
[[nodiscard]] inline std::vector<std::vector<double>> mistake_scores(const std::vector<KnownScene>& scenes,
                                                                     int paths, int threads) {
    std::vector<std::vector<double>> scores;
    for (const auto& row : mistake_rows) {
        auto& z = scores.emplace_back();
        for (const auto& known : scenes) {
            const MistakenPaths tracer(known.scene, row.mistake);
            const Running       L = path_mean(
                      paths, threads, [&](RandomPoint& point) { return tracer.radiance(known.ray, point).g; });
            const double error = std::max(L.standard_error(), 1e-6 * known.radiance);
            z.push_back(z_test(L.mean(), error, known.radiance).z);
        }
    }
    return scores;
}

/// As many digits as say something.
[[nodiscard]] inline std::string score_text(double z) {
    if (std::abs(z) > 999) return z > 0 ? "> 1000" : "< -1000";
    return fmt::format("{:.{}f}", z, std::abs(z) > found_from ? 0 : 1);
}

/// A field for each pair, dark where the scene finds the mistake.
inline void draw_mistakes(course::Diagram diagram, const std::vector<KnownScene>& scenes,
                          const std::vector<std::vector<double>>& scores) {
    using namespace course;
    constexpr double width = 2.4, height = 1;
    const double     left = 0, top = height * double(mistake_rows.size());
    for (std::size_t column = 0; column < scenes.size(); ++column) {
        const double      x    = left + width * (double(column) + 0.5);
        const std::string name = scenes[column].name;
        const auto        blank =
            name.rfind(' ', name.find(' ') == name.rfind(' ') ? std::string::npos : name.rfind(' ') - 1);
        diagram.label({x, top + 0.95}, name.substr(0, blank), Anchor::centre);
        diagram.label({x, top + 0.45}, name.substr(blank + 1), Anchor::centre);
    }
    for (std::size_t row = 0; row < mistake_rows.size(); ++row) {
        const double y = top - height * (double(row) + 1);
        diagram.label({left - 0.2, y + height / 2}, std::string(mistake_rows[row].name), Anchor::right);
        for (std::size_t column = 0; column < scenes.size(); ++column) {
            const double x = left + width * double(column), z = scores[row][column];
            const bool   found = std::abs(z) > found_from;
            diagram.polygon({{x, y}, {x + width, y}, {x + width, y + height}, {x, y + height}},
                            {found ? Ink::vermilion : Ink::grey, Weight::thin}, found ? 0.45 : 0.08);
            diagram.label({x + width / 2, y + height / 2}, score_text(z), Anchor::centre);
        }
    }
}

inline void show_mistakes(course::Chapter& chapter) {
    constexpr int paths  = 30'000;  // in a draft as well: what is found depends on it
    const auto    scenes = known_scenes();
    const auto    scores = mistake_scores(scenes, paths, chapter.options().threads);
    auto          figure = chapter.diagram("mistakes", "Which scene finds which mistake");
    draw_mistakes(figure, scenes, scores);
    figure.caption(
        fmt::format("Means of {} paths, in standard errors from what they must be; orange: more than {}.",
                    paths, found_from));
    int as_told = 0;
    for (std::size_t row = 0; row < mistake_rows.size(); ++row)
        for (std::size_t column = 0; column < scenes.size(); ++column)
            as_told +=
                (std::abs(scores[row][column]) > found_from) == (mistake_rows[row].found[column] == 'x');
    const course::Claims claim{chapter, "10.6"};
    claim("pairs of scene and mistake that are found or missed as the text says, of 48", 48, as_told, 0);
}

}  // namespace sr
