#pragma once
/// @file known_charts.hpp
/// Section 10.6: the path tracer against closed forms, bounce by bounce and along lines.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <string>
#include <utility>

#include "course/chapter.hpp"
#include "course/claims.hpp"
#include "known_scenes.hpp"
#include "material/phong_albedo.hpp"
#include "math/degrees.hpp"
#include "math/extremes.hpp"

namespace sr {

/// The farthest that any measurement of a section was from its closed form [standard errors].
class Worst {
public:
    /// @return the estimate, for a chart
    Estimate add(const Running& measured, double expected) {
        const double error = std::max(measured.standard_error(), 1e-6 * expected);
        z_                 = max_or_nan(z_, std::abs(measured.mean() - expected) / error);
        return {measured.mean(), measured.standard_error()};
    }

    /// No more than 4.5: of 100 right ones, one is beyond in one case of 1500.
    void claim(course::Chapter& chapter, const std::string& what) const {
        chapter.claim_at_most(fmt::format("10.6 {}, farthest from exact [standard errors]", what), z_, 4.5);
    }

private:
    double z_ = 0;
};

/// Each scene by 20 000 paths, as the text prints it; to half the last digit and four standard errors.
inline void claim_known_scenes(course::Chapter& chapter) {
    auto scenes = known_scenes();
    scenes.push_back(mirror_ball());
    constexpr std::array printed{0.5, 2.0, 1.0, 0.244, 0.3977, 0.3534, 5.0};
    course::Rows         rows{{"scene", "exact", "by paths", "standard error"}};
    const course::Claims claim{chapter, "10.6"};
    for (std::size_t i = 0; i < scenes.size(); ++i) {
        const auto L = traced_mean(scenes[i], 20'000, chapter.options().threads);
        rows.add({scenes[i].name, scenes[i].radiance, L.mean(), L.standard_error()});
        claim(scenes[i].name, printed[i], L.mean(), 5e-5 + 4 * L.standard_error());
    }
    chapter.say(rows);
    // of Phong's lobe as he wrote it, 0.1 max(0, r.wi)^10, at 0 and 60 degrees
    claim("1 - a of the lobe 0.1 cos^10 from above", 0.948, 1 - 0.1 * phong_albedo(10, 0), 5e-4);
    claim("1 - a of the lobe 0.1 cos^10 under 60 degrees", 0.974, 1 - 0.1 * phong_albedo(10, radians(60)),
          5e-4);
}

/// Paths of at most k bounces in two balls that shine, with roulette from the first bounce on.
inline void chart_shining_balls(course::Chapter& chapter) {
    auto chart =
        chapter.chart("shining_ball", "Inside a ball that shines, bounce by bounce",
                      course::with_error({.x = "most bounces of a path", .y = "radiance [W/(m$^2$ sr)]"}));
    Worst worst;
    for (const auto& [rho, ink] : {std::pair{0.5, course::Ink::blue}, {0.9, course::Ink::vermilion}}) {
        const std::string exact = fmt::format("exact, $\\rho = {}$", rho),
                          paths = fmt::format("paths, $\\rho = {}$", rho);
        KnownScene known        = shining_ball();
        known.scene             = inside_of_a_ball(float(rho), 1);
        for (int k = 0; k <= 24; ++k) chart.add(exact, k, Estimate{inside_after(rho, k), 0});
        for (int k = 0; k <= 24; k += 2) {
            const auto L =
                traced_mean(known, 10'000, chapter.options().threads, {.bounces = k, .roulette = 1});
            chart.add(paths, k, worst.add(L, inside_after(rho, k)));
        }
        chart.as_line(exact);
        chart.as_points(paths);
        chart.in_ink(exact, ink);
        chart.in_ink(paths, ink);
    }
    chart.caption("Lines: (10.20). Dots: means of 10 000 paths, with their standard errors.");
    worst.claim(chapter, "a ball that shines");
}

/// The floor from the ball's foot outwards, and the wall from the lamp's side to the far one.
inline void chart_profiles(course::Chapter& chapter) {
    const int threads = chapter.options().threads;
    auto      floor   = chapter.chart(
               "ball_on_floor", "A floor by a ball, under the sky",
               course::with_error({.x = "distance from the foot [radii]", .y = "radiance [W/(m$^2$ sr)]"}));
    Worst of_floor;
    for (int i = 1; i <= 80; ++i)
        floor.add("exact", i / 20.0, Estimate{floor_by_a_ball(i / 20.0).radiance, 0});
    for (int i = 1; i <= 16; ++i) {
        const auto known = floor_by_a_ball(i / 4.0);
        floor.add("paths", i / 4.0, of_floor.add(traced_mean(known, 4'000, threads), known.radiance));
    }
    auto  wall = chapter.chart("lamp_in_ball", "A lamp off the middle of a ball",
                               course::with_error({.x = "angle from the lamp, at the middle [deg]",
                                                   .y = "radiance [W/(m$^2$ sr)]"}));
    Worst of_wall;
    for (int angle = 0; angle <= 180; angle += 3) {
        const double exact = lamp_in_a_ball(radians(angle)).radiance;
        wall.add("exact", angle, Estimate{exact, 0});
        wall.add("exact, without the lamp's own", angle,
                 Estimate{LampInABall::rho / std::numbers::pi * LampInABall::indirect(), 0});
    }
    for (int angle = 0; angle <= 180; angle += 12) {
        const auto known = lamp_in_a_ball(radians(angle));
        wall.add("paths", angle, of_wall.add(traced_mean(known, 10'000, threads), known.radiance));
    }
    for (auto* chart : {&floor, &wall}) {
        chart->as_line("exact");
        chart->as_points("paths");
    }
    wall.as_line("exact, without the lamp's own");
    floor.caption("Line: (10.21). Dots: means of 4000 paths.");
    wall.caption("Lines: (10.22). Dots: means of 10 000 paths.");
    of_floor.claim(chapter, "the floor by a ball");
    of_wall.claim(chapter, "the lamp in a ball");
}

}  // namespace sr
