#pragma once
/// @file link_oracle.hpp

#include <vector>

#include "radiosity/quadtrees.hpp"
#include "radiosity/radiosity_link.hpp"

namespace sr {

/// What says that a link is too coarse.
enum class LinkOracle {
    power,  ///< what it carries, rho_a F_ab B_b A_a: Hanrahan, Salzman and Aupperle's BF, equation (8.25)
    error,  ///< how wrong a receiver's links make it, together, equations (8.26) to (8.28)
};

/// One of a link's two nodes, or neither.
enum class LinkEnd : std::uint8_t { none, receiver, source };

/// Which node of each link has to be replaced by its children, for nothing to be above `bound`: power in W, or error
/// as radiosity times the square root of its area [W/m]; of the worst primary.
/// @param rays  behind each link's visible share
[[nodiscard]] std::vector<LinkEnd> ends_to_cut(LinkOracle oracle, const Quadtrees& trees,
                                               const std::vector<RadiosityLink>& links,
                                               const Radiosities& radiosities, int rays, double bound);

}  // namespace sr
