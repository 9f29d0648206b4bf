#pragma once
/// @file drawing.hpp
/// What this chapter's diagrams are made of.

#include <cmath>
#include <string>
#include <vector>

#include "course/diagram.hpp"
#include "math/degrees.hpp"

namespace sr {

using course::Anchor;
using course::Ink;
using course::Point;
using course::Weight;

/// The unit vector at an angle [deg], counted from the right.
[[nodiscard]] inline Point towards(double angle) {
    return {std::cos(radians(angle)), std::sin(radians(angle))};
}

/// A part of a circle, from one angle [deg] to another.
[[nodiscard]] inline std::vector<Point> arc(Point centre, double radius, double from, double to) {
    std::vector<Point> points;
    for (int i = 0; i <= 64; ++i) points.push_back(centre + radius * towards(from + (to - from) * i / 64));
    return points;
}

}  // namespace sr
