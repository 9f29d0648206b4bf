#pragma once
/// @file corner_weights.hpp

#include <array>

#include "radiosity/patch.hpp"

namespace sr {

/// What a patch's corners weigh at a point of it, so that they sum up to 1 and their mean is the point: a triangle's
/// area coordinates (the fourth is 0), a quadrilateral's (1-s)(1-t), s(1-t), st and (1-s)t where patch.at({s, t}) is
/// the point. Along a side only its two ends weigh: what is interpolated by them has no gap between neighbours.
/// @pre the point lies in the patch's plane, and in the patch or so near that rounding put it outside
[[nodiscard]] std::array<double, 4> corner_weights(const Patch& patch, const Patch::Point& point);

}  // namespace sr
