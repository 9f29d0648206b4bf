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
#include <string>
#include <string_view>
#include <vector>

#include "cornell_solution.hpp"
#include "lit_part.hpp"
#include "radiosity/patch_view.hpp"
#include "scene/scene_view.hpp"

namespace sr {

/// A scene with its light, and where it is seen from.
struct OwnScene {
    SolvedScene    solved;
    Camera<double> camera;
};

inline constexpr std::size_t most_own_faces = 2000;  ///< each has two sides: a matrix of 128 MB

/// Cut as fine as about a thousand patches allow, or not at all if the faces are more.
[[nodiscard]] inline Patches cut_to_a_thousand(const std::vector<Polygon>& polygons) {
    double area = 0, longest = 0;
    for (const auto& polygon : polygons) {
        area += polygon.shape.area();
        longest = std::max(longest, polygon.shape.longest_side());
    }
    double size = std::max(std::sqrt(area / 1000), longest / 1000);  // a needle is long, and has no area
    for (;; size *= 1.25) {
        Patches patches = cut(polygons, size);
        if (patches.size() <= 1000 || patches.size() == polygons.size()) return patches;
    }
}

inline void check_own(const std::vector<Polygon>& polygons) {
    const auto shines = [](const Polygon& polygon) { return mean(polygon.emission) > 0; };
    if (polygons.empty()) throw std::invalid_argument("no face has an area");
    if (polygons.size() > 2 * most_own_faces)
        throw std::invalid_argument(
            fmt::format("it has {} faces; must be {} at most, for each pair has a form factor",
                        polygons.size() / 2, most_own_faces));
    if (std::none_of(polygons.begin(), polygons.end(), shines))
        throw std::invalid_argument("nothing shines, and all is black; must have a material with Ke above 0");
}

/// Of materials that reflect all light of a primary, the names.
[[nodiscard]] inline std::string white_materials(const Scene& scene) {
    std::string names;
    for (const auto& material : scene.materials)
        if (largest(material.reflectance()) >= 1) names += fmt::format(" '{}'", material.name);
    return names.empty() ? "" : " (Kd is 1 in" + names + ")";
}

/// The scene of --scene, in which faces are lit from either side, solved.
/// @throws std::runtime_error    as read_obj
/// @throws std::invalid_argument if radiosity can't do it: see polygons_of and check_system; or too many faces, or none
///                               that shines
[[nodiscard]] inline std::optional<OwnScene> own_scene(course::Chapter& chapter) {
    const auto& options = chapter.options();
    if (!options.scene) return std::nullopt;
    const auto view =
        view_of_file(*options.scene, options.size, [&](std::string_view line) { chapter.note(line); });
    const double noise = 0.09;  // patches may be as large as faces are, and go through each other
    std::string  hint;
    try {
        const auto polygons = polygons_of(view.scene, ShiningSides::both);
        check_own(polygons);
        hint = white_materials(view.scene);
        return OwnScene{solve_patches(cut_to_a_thousand(polygons), view.scene.mesh, options.threads, noise),
                        view.camera};
    } catch (const std::invalid_argument& error) {
        throw std::invalid_argument(
            fmt::format("{}: {}{}", options.scene->filename().string(), error.what(), hint));
    }
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
    const auto&   solved = own.solved;
    const auto    values = exposed(solved, solved.at_vertices, solved.radiosities);
    const Patches lit    = lit_part(solved.patches, solved.system, solved.radiosities);
    chapter.render(
        "scene", "The scene",
        fmt::format("{} patches, both sides of all faces, of which {} get light and are shown; exposed for "
                    "what does not shine.",
                    solved.patches.size(), lit.size()),
        picture(PatchView(lit), own.camera, interpolated_radiosity(lit, values), 2,
                {chapter.options().threads}));
}

}  // namespace sr
