#pragma once
/// @file swapped_loops.hpp
/// The two nestings of "which triangle is nearest through which pixel?" against each other.

#include <concepts>

#include "geometry/hierarchy.hpp"
#include "scene/rasteriser.hpp"
#include "scene/visibility_difference.hpp"
#include "transport/primary.hpp"

namespace sr {

/// What rays and the rasteriser see of a mesh that is rounded to T, counted pixel by pixel.
template <std::floating_point T>
[[nodiscard]] VisibilityDifference compare_swapped_loops(const Mesh<double>&   exact_mesh,
                                                         const Camera<double>& exact_camera,
                                                         const TileLoop&       loop = {}) {
    const auto         mesh   = convert<T>(exact_mesh);
    const auto         camera = convert<T>(exact_camera);
    const Hierarchy<T> hierarchy(mesh);
    return compare_visibility(trace_primary(hierarchy, camera, loop), rasterise(mesh, camera), mesh, camera);
}

}  // namespace sr
