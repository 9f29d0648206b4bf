#pragma once
/// @file render.hpp
/// A scene as chapter 1 looks at it: three renders of what its rays found.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "course/chapter.hpp"
#include "course/number.hpp"
#include "geometry/hierarchy.hpp"
#include "scenes.hpp"
#include "shading.hpp"
#include "transport/primary.hpp"

namespace sr {

/// Each pixel's mean of `options.samples` rays, which pass through the middles of a square grid in it.
[[nodiscard]] inline Image<Look> look_through(const Shot& shot, const course::Options& options,
                                              const std::string& name) {
    // Moved to the camera in double, then rounded: section 1.5 says why.
    const Hierarchy<float> hierarchy(convert<float>(to_camera_space(shot.scene.mesh, shot.camera)));
    const auto             camera = convert<float>(in_camera_space(shot.camera));
    const auto depths = depth_range(trace_primary(hierarchy, camera, {.threads = options.threads}));

    const int        rays  = options.samples;  // a square: course::run has seen to that
    const int        side  = int(std::sqrt(rays));
    const float      share = 1 / float(rays);
    Image<Look>      looks(camera.width, camera.height, {{}, {}, {}});
    course::Progress progress("tracing " + name, 1000);
    const TileLoop   loop{.threads = options.threads,
                          .on_tile = [&](int done, int of) { progress.tick_part(done, of); }};
    for_each_pixel(camera.width, camera.height, loop, [&](int x, int y) {
        for (int part = 0; part < rays; ++part) {
            const int  row = part / side, column = part % side;
            const Vec2 image{float(x) + (float(column) + 0.5F) / float(side),
                             float(y) + (float(row) + 0.5F) / float(side)};
            const auto hit = hierarchy.nearest(camera.ray(image));
            looks(x, y).add(
                share, hit ? look_at(shot.scene, hit->face, shot.camera.ray(image).direction, hit->t, depths)
                           : Look{});
        }
    });
    return looks;
}

/// Renders the scene by depth, by normal and by a light at the eye.
inline void render(course::Chapter& chapter, const std::string& name, const std::string& title,
                   const Shot& shot) {
    const auto looks = look_through(shot, chapter.options(), name);
    if (std::none_of(looks.pixels().begin(), looks.pixels().end(), is_something))
        chapter.note(name + ": no ray hits anything, its pictures are blank");

    const auto facts =
        fmt::format("{}, {} a pixel", course::counted(std::ssize(shot.scene.mesh.faces), "triangle"),
                    course::counted(chapter.options().samples, "ray"));
    const auto show = [&](const std::string& suffix, Spectrum Look::*way, const std::string& by,
                          const std::string& meaning) {
        Image<Spectrum> film(looks.width(), looks.height());
        for (std::size_t i = 0; i < film.pixels().size(); ++i) film.pixels()[i] = looks.pixels()[i].*way;
        chapter.render(name + "_" + suffix, title + " by " + by, facts + ": " + meaning + ".", film);
    };
    show("depth", &Look::depth, "depth", "bright is near, by the square of the nearness; black is nothing");
    show("normal", &Look::normal, "normal", "each axis is a primary colour");
    show("head_light", &Look::head_light, "a head light", "a light at the eye, equation (1.4)");
}

}  // namespace sr
