#pragma once
/// @file mesh_strip.hpp
/// The quadtrees over what they compute.

#include "course/chapter.hpp"
#include "radiosity/hierarchical_radiosity.hpp"
#include "radiosity/patch_view.hpp"
#include "scene/cornell_box.hpp"
#include "scene/visible.hpp"

namespace sr {

/// The leaves from the published camera; a pixel whose neighbour to the right or below sees another leaf is darkened.
inline Image<Spectrum> picture_of_mesh(const HierarchicalSolution& solution, int side, int threads) {
    const Patches     leaves      = solution.trees.leaves();
    const Radiosities radiosities = solution.trees.of_leaves(solution.radiosities);
    const PatchView   view(leaves);
    const auto        camera = cornell_box_camera(side);
    Image<Spectrum>   film  = picture(view, camera, constant_radiosity(radiosities), 1, {.threads = threads});
    const auto        patch = [&](int x, int y) {
        const auto seen = view.seen(camera.ray_through_pixel(x, y));
        return seen ? seen->patch : Visible<double>::nothing;
    };
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x) {
            const auto here = patch(x, y);
            if (here != patch(x + 1, y) || here != patch(x, y + 1)) film(x, y) = 0.45F * film(x, y);
        }
    return film;
}

}  // namespace sr
