#pragma once
/// @file vanishing_room.hpp
/// Section 10.6: a room with all that the core can make, lit by a lamp; and the same room when everything in it emits
/// what it absorbs.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "course/chapter.hpp"
#include "sampling/random_point.hpp"
#include "scene/small_scenes.hpp"
#include "scene/teapot.hpp"
#include "statistics/running.hpp"
#include "transport/path_tracer.hpp"
#include "transport/traced.hpp"

namespace sr {

/// Faces of another mesh, moved and scaled.
inline void add_mesh(Scene& scene, const Mesh<double>& mesh, double scale, const Vector3<double>& move,
                     std::uint32_t material) {
    const auto first = std::uint32_t(scene.mesh.vertices.size());
    for (const auto& vertex : mesh.vertices) scene.mesh.vertices.push_back(scale * vertex + move);
    for (const auto& [a, b, c] : mesh.faces) scene.mesh.faces.push_back({first + a, first + b, first + c});
    scene.material_of_face.insert(scene.material_of_face.end(), mesh.faces.size(), material);
}

/// A cube of 2 with coloured walls; in it a teapot and balls of paint, mirror and glass, none in another: in glass, 1
/// would have to be n^2. A lamp hangs below the ceiling.
[[nodiscard]] inline Scene room_by_lamplight() {
    const Spectrum white{0.8F, 0.8F, 0.8F}, silver{0.8F, 0.8F, 0.9F};
    Scene          scene;
    scene.materials = {diffuse_material("left", {0.7F, 0.15F, 0.1F}),
                       diffuse_material("right", {0.1F, 0.3F, 0.7F}),
                       diffuse_material("near", white),
                       diffuse_material("far", white),
                       diffuse_material("floor", {0.6F, 0.55F, 0.45F}),
                       diffuse_material("ceiling", white),
                       {"silver", LobeSum<float>{{{silver, Mirror<float>{}}}}},
                       {"glass", LobeSum<float>{{{{1, 1, 1}, Dielectric<float>{1.5F}}}}},
                       diffuse_material("orange", {0.8F, 0.4F, 0.05F}),
                       {"glaze", LobeSum<float>{{{{0.5F, 0.5F, 0.5F}, Diffuse<float>{}},
                                                 {{0.2F, 0.2F, 0.2F}, Mirror<float>{}}}}},
                       diffuse_material("lamp", {0, 0, 0}, {2.5F, 2.5F, 2.5F})};
    add_cube(scene, -1, 1);
    scene.balls = {
        {{{-0.55, 0.5, -0.65}, 0.35}, 6}, {{{0.55, -0.1, -0.72}, 0.28}, 7}, {{{-0.35, 0, -0.83}, 0.17}, 8}};
    add_mesh(scene, teapot(8), 0.18, {0.32, 0.62, -1}, 9);
    add_quad(scene, {{{-0.6, -0.3, 0.98}, {-0.6, 0.9, 0.98}, {0.6, 0.9, 0.98}, {0.6, -0.3, 0.98}}}, 10);
    return scene;
}

/// The same when each of its materials emits 1 - a, equation (10.19).
/// @param mistake  by which the reflectances are multiplied after that, and what is emitted stays: 1 is right
[[nodiscard]] inline Scene room_that_vanishes(float mistake = 1) {
    Scene scene = room_by_lamplight();
    for (auto& material : scene.materials) {
        // what is not given back is emitted
        material.emission = Spectrum{1, 1, 1} - material.reflectance();
        auto lobes        = material.scattering.lobes();
        if (!material.is_transparent())
            for (auto& lobe : lobes) lobe.weight = mistake * lobe.weight;
        material.scattering = LobeSum<float>(lobes);
    }
    return scene;
}

[[nodiscard]] inline Camera<double> camera_in_the_room(int width, int height) {
    return pinhole_camera<double>({0, -0.98, 0.1}, {0, 1, -0.32}, {0, 0, 1}, 0.72, 1, width, height);
}

inline void render_vanishing_room(course::Chapter& chapter) {
    using course::Quality;
    const auto& options = chapter.options();
    const auto  camera  = camera_in_the_room(3 * options.size / 4, 3 * options.size / 4);
    const auto  samples =
        std::uint32_t(course::ByQuality{.draft = 16, .lecture = 64, .print = 1024}.at(options.quality));
    course::Progress progress("a room, twice", 2000);
    const TileLoop   loop{.threads = options.threads, .on_tile = [&](int done, int of) {
                            progress.tick(course::steps_of_part(1000, done, of));
                        }};
    chapter.render("room_by_lamplight", "A room by lamplight", fmt::format("{} paths a pixel.", samples),
                   traced(room_by_lamplight(), camera, {}, {.samples = samples}, loop).mean());
    const std::uint32_t few   = 16;
    auto                known = traced(room_that_vanishes(), camera, {}, {.samples = few}, loop).mean();
    for (auto& pixel : known.pixels()) pixel = 0.5F * pixel;
    chapter.render("room_that_vanishes", "The same room, when all in it emits what it absorbs",
                   fmt::format("{} paths a pixel, half as bright as it is.", few), known);
}

/// How far the pixels are from 1 [their standard errors], of a small picture with so many independent paths in each.
/// Roulette comes late: what it multiplies makes means of few paths lopsided.
[[nodiscard]] inline std::vector<double> scores_of_pixels(const Scene& scene, int side, int paths,
                                                          int threads) {
    const PathTracer    tracer(scene, {.roulette = 12});
    const auto          camera = convert<float>(camera_in_the_room(side, side));
    std::vector<double> scores(std::size_t(side) * std::size_t(side));
    for_each_pixel(side, side, {.threads = threads}, [&](int x, int y) {
        Running   brightness;
        PathCount count;
        for (int i = 0; i < paths; ++i) {
            RandomPoint point(SampleId{.x = x, .y = y, .index = std::uint32_t(i)});
            const Vec2  at = Vec2{float(x), float(y)} + point.pair<float>();
            brightness.add(double(mean(tracer.radiance(camera.ray(at), point, count))));
        }
        scores[std::size_t(y) * std::size_t(side) + std::size_t(x)] =
            (brightness.mean() - 1) / std::max(brightness.standard_error(), 1e-6);
    });
    return scores;
}

}  // namespace sr
