#pragma once
/// @file visible_share.hpp
/// What rays between random points of two patches say.

#include <array>

#include "radiosity/patch.hpp"
#include "radiosity/visibility.hpp"
#include "sampling/rng.hpp"

namespace sr {

/// Of the light that would pass between two patches, the share that nothing keeps from it [0, 1]: a quotient of sums
/// over side^2 stratified pairs of points, which count as (8.5) weighs them. It is 1 and 0 exactly where all points
/// or none see each other, and 1 where there is no light to pass. Its standard error is at most about sqrt(v (1 - v))
/// / side, where v is the share, and less by what strata save: of half a square, 1.2 % of the share by 4096 rays.
/// @pre side >= 1, the patches face each other
[[nodiscard]] double visible_share(const Patch& a, const Patch& b, const Visibility& visibility, int side,
                                   Rng& rng);

/// The same in four parts: which share of the light passes to each quarter of b.
/// @pre side is even
[[nodiscard]] std::array<double, 4> visible_quarters(const Patch& a, const Patch& b,
                                                     const Visibility& visibility, int side, Rng& rng);

/// The same from one point, by a ray into each of the patch's side^2 strata. What is behind the point's own surface
/// has weight 0: it is no part of the form factor that is shared out, and must not count as hidden. The standard
/// error is at most about sqrt(v (1 - v)) / side here, too.
/// @pre side >= 1
[[nodiscard]] double visible_share(const SurfacePoint<double>& from, const Patch& to,
                                   const Visibility& visibility, int side, Rng& rng);

/// The form factor F [1] itself from such pairs: the mean of (8.5) over both patches, times the area of the second. Its
/// mean over repeats is right, and its standard error is theirs; that of one is unbounded where the patches touch.
/// @pre side >= 1
[[nodiscard]] double sampled_form_factor(const Patch& from, const Patch& to, const Visibility& visibility,
                                         int side, Rng& rng);

}  // namespace sr
