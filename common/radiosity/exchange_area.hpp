#pragma once
/// @file exchange_area.hpp

#include "radiosity/patch.hpp"

namespace sr {

/// A_1 F_12 = A_2 F_21 of two patches with nothing between them [length unit^2]: how much area of perfect sight they
/// have in common, equations (8.7) and (8.11).
///
/// Of the smaller one, what lies before the other's surface is summed up by Gauss and Legendre's rules, and the other one
/// is exact from each of their points. Where rules of one, two and three points a side differ by more than `tolerance`
/// times the whole (or a thousandth of the patch, if that is more), the patch is quartered, and each quarter may differ by
/// half as much: it is cut small next to what it touches, and stays whole elsewhere.
/// @pre tolerance > 0
[[nodiscard]] double exchange_area(const Patch& a, const Patch& b, double tolerance = 1e-3);

}  // namespace sr
