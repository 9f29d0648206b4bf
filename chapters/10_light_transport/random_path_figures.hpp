#pragma once
/// @file random_path_figures.hpp
/// Section 10.1: pictures by random paths, their errors, and what a largest number of bounces leaves out.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <tuple>
#include <vector>

#include "box_by_paths.hpp"
#include "course/claims.hpp"
#include "picture_grid.hpp"
#include "scene/small_scenes.hpp"
#include "statistics/slope.hpp"

namespace sr {

/// Directions blind above, by the BSDF below; 1, 16 and 256 paths in each pixel.
inline void render_random_paths(course::Chapter& chapter) {
    const int                    side = std::max(chapter.options().size / 2, 16);
    std::vector<Image<Spectrum>> pictures;
    course::Progress             progress("following random paths", 2 * (1 + 16 + 256));
    for (const auto strategy : {Strategy::blind, Strategy::bsdf})
        for (const int paths : {1, 16, 256}) {
            const TileLoop loop{.threads = chapter.options().threads,
                                .on_tile = [&, paths](int done, int of) {
                                    progress.tick(course::steps_of_part(paths, done, of));
                                }};
            pictures.push_back(box_by_paths(strategy, std::uint32_t(paths), side, loop));
        }
    chapter.render("random_paths", "The Cornell box by 1, 16 and 256 random paths a pixel",
                   "Above, directions are drawn blindly; below, by the BSDF.", grid_of(pictures, 3));
}

/// The errors of a small box, and the power of n with which they fall. Tolerances are four standard errors.
inline void chart_random_paths(course::Chapter& chapter) {
    auto chart = chapter.chart(
        "random_path_errors", "The Cornell box by random paths",
        course::with_error({.x = "paths in each pixel", .y = "relative RMSE", .log = course::axis::xy}));
    const SmallBox       box(chapter.options().threads);
    const course::Claims claim{chapter, "10.1"};
    for (const auto& [name, strategy, one, many] :
         {std::tuple{"blind", Strategy::blind, 16.0, 1.08}, {"BSDF", Strategy::bsdf, 12.0, 0.79}}) {
        std::vector<double>   paths;
        std::vector<Estimate> errors;
        for (const std::uint32_t n : {1U, 16U, 256U}) {
            errors.push_back(box.error(strategy, n));
            paths.push_back(n);
            chart.add(name, n, errors.back());
        }
        const auto of  = std::string(name) + ", ";
        const auto fit = log_log_slope(paths, errors);
        claim(of + "1 path: relative RMSE", one, errors[0].value, 4 * errors[0].error);
        claim(of + "256 paths: relative RMSE", many, errors[2].value, 4 * errors[2].error);
        claim(of + "power of n with which the error falls", 0.5, -fit.value, 4 * fit.standard_error);
    }
}

/// Pixels that are black, of two boxes with 65 536 paths each.
inline void claim_black_pixels(course::Chapter& chapter) {
    const course::Claims claim{chapter, "10.1"};
    const int            threads = chapter.options().threads;
    for (const auto& [name, strategy, one, sixteen] :
         {std::tuple{"blind", Strategy::blind, 98.4, 85.0}, {"BSDF", Strategy::bsdf, 98.0, 81.0}}) {
        const auto after_one     = percent(black_pixels(strategy, 1, 256, threads));
        const auto after_sixteen = percent(black_pixels(strategy, 16, 64, threads));
        const auto of            = std::string(name) + ": black pixels after ";
        claim(of + "1 path [%]", one, after_one.value, 4 * after_one.error);
        claim(of + "16 paths [%]", sixteen, after_sixteen.value, 4 * after_sixteen.error);
    }
}

/// Inside a ball that shines, light that paths of so many bounces at most miss: rho^(k + 1) of it (row H17).
inline void claim_missing_light(course::Chapter& chapter) {
    const course::Claims claim{chapter, "10.1"};
    course::Rows         table{{"reflectance", "bounces", "missing [%]", "seen missing [%]"}};
    for (const auto& [rho, bounces, printed, digit] : {std::tuple{0.5, 5, 1.56, 0.01},
                                                       {0.5, 10, 0.049, 0.001},
                                                       {0.9, 5, 53.1, 0.1},
                                                       {0.9, 10, 31.4, 0.1}}) {
        const PathTracer tracer(inside_of_a_ball(float(rho), 1),
                                {.strategy = Strategy::bsdf, .bounces = bounces, .roulette = bounces});
        RandomPoint      point(SampleId{});
        PathCount        count;  // one path is enough: each counts the same
        const Spectrum   L       = tracer.radiance({{0.1F, 0.2F, 0}, {0, 0, 1}}, point, count);
        const double     missing = 100 * (1 - double(L.g) * (1 - rho));
        table.add({rho, bounces, 100 * std::pow(rho, bounces + 1), missing});
        claim("a ball of " + std::to_string(rho).substr(0, 3) + ", " + std::to_string(bounces) +
                  " bounces: light that is missing [%]",
              printed, missing, digit / 2);
    }
    chapter.say(table);
}

}  // namespace sr
