#pragma once
/// @file surface_samples.hpp
/// Solutions on different meshes, compared as what they are: functions on the same surfaces.

#include <cstdint>
#include <span>
#include <vector>

#include "radiosity/hierarchical_radiosity.hpp"
#include "radiosity/rows.hpp"

namespace sr {

/// A point of a polygon.
struct SurfaceSample {
    Vector3<double> position;
    Vector3<double> normal;
    std::uint32_t   polygon;
};

/// So many points, each of the same share of all the area.
/// @pre count >= 1, polygons is not empty
[[nodiscard]] std::vector<SurfaceSample> surface_samples(std::span<const Polygon> polygons, int count,
                                                         std::uint64_t seed);

/// What is reflected at each point, B - E, of patches with one radiosity each [W/m^2].
/// @throws std::invalid_argument where a point lies on none of its polygon's patches
[[nodiscard]] Radiosities reflected_at(std::span<const SurfaceSample> samples, const Patches& patches,
                                       const Radiosities& radiosities);

/// The same as the polygon's own point receives it over all links of the leaf there and of the nodes above it: their
/// sources' form factors are exact from a point, and rays to each find what is hidden, and in which quarter. A step of
/// Jacobi's iteration at a point: errors of the sources are averaged out, and no patch is in the way of the receiver's
/// shadow's edge.
/// @param strata  the square of it is the number of rays to a source; lamps get 16 times as many
/// @pre   strata >= 1
/// @see   Lischinski, Tampieri and Greenberg, Combining Hierarchical Radiosity and Discontinuity Meshing (1993)
[[nodiscard]] Radiosities gathered_at(std::span<const SurfaceSample> samples,
                                      const HierarchicalSolution& solution, const Visibility& visibility,
                                      int strata, const RowLoop& loop = {});

/// Root mean square of the difference over that of the reference, over all samples and primaries [1].
/// @pre as many of both
[[nodiscard]] double relative_rms(const Radiosities& measured, const Radiosities& reference);

}  // namespace sr
