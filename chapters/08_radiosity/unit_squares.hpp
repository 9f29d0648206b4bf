#pragma once
/// @file unit_squares.hpp
/// Pairs of unit squares whose form factor is known.

#include <array>
#include <string>
#include <vector>

#include "radiosity/closed_form_factors.hpp"
#include "radiosity/patches.hpp"
#include "radiosity/visibility.hpp"

namespace sr {

/// [0, 1]^2 at the height z, its front upwards.
[[nodiscard]] inline Patch level_square(double z = 0) {
    return {{0, 0, z}, {1, 0, z}, {1, 1, z}, {0, 1, z}};
}

/// On the side x = 0 of level_square(), its front to +x.
[[nodiscard]] inline Patch upright_square() {
    return {{0, 0, 0}, {0, 1, 0}, {0, 1, 1}, {0, 0, 1}};
}

/// The middle half of level_square(1/2), which is in the way of the upper one.
[[nodiscard]] inline Patch blocking_square() {
    return {{0.25, 0.25, 0.5}, {0.75, 0.25, 0.5}, {0.75, 0.75, 0.5}, {0.25, 0.75, 0.5}};
}

/// Two patches, perhaps others between them, and the form factor from the first to the second.
struct KnownPair {
    std::string name;
    Patches     patches;  ///< the first and the second, then what is in the way
    double      exact;

    [[nodiscard]] const Patch& from() const { return patches.shapes[0]; }
    [[nodiscard]] const Patch& to() const { return patches.shapes[1]; }
    [[nodiscard]] Visibility   visibility() const { return Visibility{mesh_of(patches).mesh}; }
};

[[nodiscard]] inline KnownPair known_pair(const std::string& name, const std::vector<Patch>& shapes,
                                          double exact) {
    std::vector<Polygon> polygons;
    for (const Patch& shape : shapes) polygons.push_back({shape, {}, {}, 0});
    return {name, cut(polygons, 1), exact};
}

/// From one unit square to another at the distance 1, with blocking_square() in the way. Lines with the slopes (u, v)
/// pass through both in an area (1 - |u|)(1 - |v|), and through the blocker in b(u) b(v), b being the length of x for
/// which x and x + u lie in [0, 1] and x + u/2 in [1/4, 3/4]; their difference over pi (1 + u^2 + v^2)^2, summed up
/// to 18 digits over slopes from -1 to 1, split at 0 and 1/2, where b has its kinks.
inline constexpr double behind_a_square = 0.099506294598984786;

/// Opposed, touching at a right angle, ten sides apart, and partly hidden.
[[nodiscard]] inline std::array<KnownPair, 4> known_pairs() {
    return {
        known_pair("opposed", {level_square(), level_square(1).reversed()}, opposed_rectangles(1, 1, 1)),
        known_pair("touching", {level_square(), upright_square()}, perpendicular_rectangles(1, 1, 1)),
        known_pair("distant", {level_square(), level_square(10).reversed()}, opposed_rectangles(1, 1, 10)),
        known_pair(
            "occluded",
            {level_square(), level_square(1).reversed(), blocking_square(), blocking_square().reversed()},
            behind_a_square)};
}

}  // namespace sr
