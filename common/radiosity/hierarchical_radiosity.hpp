#pragma once
/// @file hierarchical_radiosity.hpp
/// Radiosity whose cost grows as the number of patches, not as its square. How to use:
///     const auto        polygons = polygons_of(scene);
///     const auto        solution = hierarchical_radiosity(polygons, Visibility{scene.mesh}, {.bound = 1e-3});
///     const Patches     patches  = solution.trees.leaves();
///     const Radiosities values   = solution.trees.of_leaves(solution.radiosities);

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "radiosity/link_oracle.hpp"
#include "radiosity/quadtrees.hpp"
#include "radiosity/radiosity_link.hpp"
#include "radiosity/visibility.hpp"

namespace sr {

/// How finely light is exchanged.
struct HierarchicalSettings {
    /// For the power on a link, as a share of all that lamps emit; or for a receiver's error, as a share of that power
    /// over the square root of all area: of n leaves, the root mean square error is about bound sqrt(n) [1]. Of the
    /// Cornell box, 0.01 makes 644 leaves, whose radiosities are off by 11 %, and 0.0025 makes 3266, off by 5.6 %.
    double        bound     = 2.5e-3;
    LinkOracle    oracle    = LinkOracle::error;
    double        smallest  = 0;     ///< area that no leaf is below [length unit^2]
    double        tolerance = 1e-4;  ///< of light that is still to come, relative to what is reflected [1]
    int           strata    = 4;     ///< an even number; visibility rays of a link are the square of it
    std::uint64_t seed      = 1;     ///< of the points that they start from
    int           threads   = 1;     ///< 0: one for each processor; the result is the same

    std::function<void(int links)> on_links = {};  ///< told of links as they are computed, from any thread
};

/// Radiosities of all nodes, in the trees' order; node i of the first ones is polygon i.
struct HierarchicalSolution {
    Quadtrees                  trees;
    std::vector<RadiosityLink> links;
    Radiosities                radiosities;  ///< [W/m^2]

    [[nodiscard]] std::size_t bytes() const;  ///< of memory
};

/// Links between whole polygons are solved first. Then links are refined and solved again, with bounds that get tighter
/// by factors of 4: so that what is refined is known from the coarser solution.
/// @throws std::invalid_argument naming a setting that makes no sense, or a polygon whose reflectance is not from 0
///                               to 1 or whose emission is negative or not finite
/// @throws std::runtime_error    where no solution is found, naming the polygons that reflect 0.99 of the light or more
/// @see    Hanrahan, Salzman and Aupperle, A Rapid Hierarchical Radiosity Algorithm, Computer Graphics 25(4), 1991
[[nodiscard]] HierarchicalSolution hierarchical_radiosity(std::span<const Polygon>    polygons,
                                                          const Visibility&           visibility,
                                                          const HierarchicalSettings& settings = {});

}  // namespace sr
