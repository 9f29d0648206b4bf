#pragma once
/// @file exchange_area.hpp

#include "radiosity/patch.hpp"

namespace sr {

/// A_1 F_12 = A_2 F_21 of two patches with nothing between them [length unit^2]: how much area of perfect sight they
/// have in common, equations (8.7) and (8.11).
///  Of the smaller one, what lies before the other's surface is summed up by Gauss and Legendre's rules, and the
/// other one is exact from each of their points. Where three points a side differ from two by more than half of
/// `tolerance` times the whole (or a thousandth of the patch, if that is more), or from one by more than the root of
/// `tolerance` times it, the patch is quartered, and each quarter may differ by half as much: it is cut small next to
/// what it touches, and stays whole elsewhere.
/// @pre tolerance > 0
/// @see Baum, Rushmeier and Winget, Improving Radiosity Solutions Through the Use of Analytically Determined
///      Form-Factors, Computer Graphics 23(3), 1989
[[nodiscard]] double exchange_area(const Patch& a, const Patch& b, double tolerance = 1e-3);

}  // namespace sr
