#pragma once
/// @file asked_and_met.hpp
/// Section 10.2: the Cornell box by light that is met by chance, and by light that is asked for.

#include <algorithm>
#include <cstdint>
#include <string>
#include <tuple>
#include <vector>

#include "box_by_paths.hpp"
#include "course/claims.hpp"
#include "picture_grid.hpp"

namespace sr {

/// How many rays a path into the box takes, shadow rays with it.
[[nodiscard]] inline Estimate rays_of_path(Strategy strategy) {
    const PathTracer tracer(cornell_box(), {.strategy = strategy});
    const auto       camera = convert<float>(cornell_box_camera(64));
    Running          rays;
    for (std::uint32_t i = 0; i < 1U << 14; ++i) {
        RandomPoint point(SampleId{.seed = 51, .index = i});
        PathCount   count;
        static_cast<void>(tracer.radiance(camera.ray(64.0F * point.pair<float>()), point, count));
        rays.add(double(count.rays + count.shadow_rays));
    }
    return {rays.mean(), rays.standard_error()};
}

/// As many rays for either, nearly: 32 paths that wait, 20 that ask.
inline constexpr std::uint32_t waiting_paths = 32, asking_paths = 20;

inline void render_asked_and_met(course::Chapter& chapter) {
    const int        side = std::max(chapter.options().size * 5 / 8, 16);
    course::Progress progress("waiting for the lamp, and asking it", int(waiting_paths + asking_paths));
    const auto       box_by = [&](Strategy strategy, std::uint32_t paths) {
        return box_by_paths(strategy, paths, side,
                                  {.threads = chapter.options().threads, .on_tile = [&](int done, int of) {
                                 progress.tick(course::steps_of_part(int(paths), done, of));
                             }});
    };
    const auto waiting = box_by(Strategy::bsdf, waiting_paths),
               asking  = box_by(Strategy::light, asking_paths);
    chapter.render("asked_and_met", "The Cornell box with as many rays, by chance and by asking the lamp",
                   "Left: 32 paths that wait for the lamp. Right: 20 that ask it at each surface.",
                   grid_of({waiting, asking}, 2));
}

/// What the text says of them; tolerances are four standard errors.
inline void claim_asked_and_met(course::Chapter& chapter) {
    const SmallBox       box(chapter.options().threads);
    const course::Claims claim{chapter, "10.2"};
    for (const auto& [name, strategy, paths, rays, printed] :
         {std::tuple{"waiting", Strategy::bsdf, waiting_paths, 3.34, 2.2},
          {"asking", Strategy::light, asking_paths, 5.31, 0.28}}) {
        const auto of_path = rays_of_path(strategy);
        const auto error   = box.error(strategy, paths);
        claim(std::string(name) + ": rays of a path", rays, of_path.value, 4 * of_path.error);
        claim(std::string(name) + ": relative RMSE", printed, error.value, 4 * error.error);
    }
}

}  // namespace sr
