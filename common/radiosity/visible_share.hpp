#pragma once
/// @file visible_share.hpp

#include "radiosity/patch.hpp"
#include "radiosity/visibility.hpp"
#include "sampling/rng.hpp"

namespace sr {

/// Of the light that would pass between two patches, the share that nothing keeps from it [0, 1]: a quotient of sums
/// over side^2 pairs of points, one of each patch's side^2 strata in each, which count as (8.5) weighs them. It is 1
/// and 0 exactly where all points or none see each other.
/// @pre side >= 1, the patches face each other
[[nodiscard]] double visible_share(const Patch& a, const Patch& b, const Visibility& visibility, int side,
                                   Rng& rng);

}  // namespace sr
