#pragma once
/// @file area_of_sides.hpp

#include <cmath>
#include <concepts>
#include <utility>

namespace sr {

/// The area of a triangle from the lengths of its sides, in any order, equation (3.12), [length unit^2]: within a few
/// units in the last place, even of a needle, where Heron's formula loses every digit. The brackets matter.
/// @return NaN where there is no such triangle: one side is longer than the others together
/// @see Kahan, Miscalculating Area and Angles of a Needle-like Triangle (2014)
template <std::floating_point T>
[[nodiscard]] T area_of_sides(T a, T b, T c) {
    if (a < b) std::swap(a, b);
    if (b < c) std::swap(b, c);
    if (a < b) std::swap(a, b);
    // (3.12) longest side first: c - (a - b) is the only difference that can cancel, and it does so exactly
    return std::sqrt((a + (b + c)) * (c - (a - b)) * (c + (a - b)) * (a + (b - c))) / 4;
}

}  // namespace sr
