#pragma once
/// @file own_scene.hpp
/// A scene that a person brings along, by radiosity.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <optional>
#include <stdexcept>
#include <string_view>
#include <vector>

#include "cornell_solution.hpp"
#include "radiosity/patch_view.hpp"
#include "scene/scene_view.hpp"

namespace sr {

/// A scene's patches, what hides them from each other, and where it is seen from.
struct OwnScene {
    Patches        patches;
    Mesh<double>   mesh;
    Camera<double> camera;
};

inline constexpr std::size_t most_own_patches = 4000;  ///< a matrix of 128 MB

/// Cut as fine as about a thousand patches allow, or not at all if the faces are more.
[[nodiscard]] inline Patches cut_to_a_thousand(const std::vector<Polygon>& polygons) {
    double area = 0;
    for (const auto& polygon : polygons) area += polygon.shape.area();
    double size = std::sqrt(area / 1000);
    for (;; size *= 1.25) {
        Patches patches = cut(polygons, size);
        if (patches.size() <= 1000 || patches.size() == polygons.size()) return patches;
    }
}

/// The scene of --scene, in which faces are lit from either side.
/// @throws std::runtime_error    as read_obj
/// @throws std::invalid_argument if radiosity can't do it: see polygons_of; or too many faces, or none that shines
[[nodiscard]] inline std::optional<OwnScene> own_scene(course::Chapter& chapter) {
    const auto& options = chapter.options();
    if (!options.scene) return std::nullopt;
    const auto name = options.scene->filename().string();
    const auto view =
        view_of_file(*options.scene, options.size, [&](std::string_view line) { chapter.note(line); });
    const auto polygons = polygons_of(view.scene, Sides::both);
    if (polygons.size() > most_own_patches)
        throw std::invalid_argument(
            fmt::format("{} has {} faces, front and back; a matrix of form factors is for {} at most", name,
                        polygons.size(), most_own_patches));
    if (std::none_of(polygons.begin(), polygons.end(),
                     [](const Polygon& polygon) { return mean(polygon.emission) > 0; }))
        throw std::invalid_argument(
            fmt::format("{}: nothing shines, and all is black; must have a material with Ke above 0", name));
    return OwnScene{cut_to_a_thousand(polygons), view.scene.mesh, view.camera};
}

/// The lamps of a file may be of any strength: the brightest of what does not shine becomes white.
[[nodiscard]] inline Radiosities exposed(const SolvedScene& scene, Radiosities radiosities,
                                         const Radiosities& of_patches) {
    double brightest = 0;
    for (std::size_t i = 0; i < of_patches.size(); ++i) {
        const auto& B = of_patches[i];
        if (scene.system.emission[i] == DoubleSpectrum{}) brightest = std::max({brightest, B.r, B.g, B.b});
    }
    const double exposure = brightest > 0 ? std::numbers::pi / brightest : 1;
    for (auto& B : radiosities) B = exposure * B;
    return radiosities;
}

inline void render_own_scene(course::Chapter& chapter, const OwnScene& own) {
    const int    threads = chapter.options().threads;
    const double noise   = 0.09;  // patches may be as large as faces are, and go through each other
    const auto   solved  = solve_patches(own.patches, own.mesh, threads, noise);
    const auto   values  = exposed(solved, solved.at_vertices, solved.radiosities);
    chapter.render("scene", "The scene",
                   fmt::format("{} patches, both sides of all faces; exposed for what does not shine.",
                               solved.patches.size()),
                   picture(PatchView(solved.patches), own.camera,
                           interpolated_radiosity(solved.patches, values), 2, {threads}));
}

}  // namespace sr
