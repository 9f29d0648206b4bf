#pragma once
/// @file drawing.hpp
/// What the diagrams of this chapter are made of.

#include "course/curves.hpp"

namespace sr {

using course::Anchor;
using course::arc;
using course::draw_angle;
using course::ellipse;
using course::Ink;
using course::Point;
using course::towards;
using course::Weight;

/// A flat piece of a surface, seen from the side: a line with a little thickness behind it.
inline void draw_surface(course::Diagram diagram, Point centre, double half, double angle, Ink ink) {
    const Point along = half * towards(angle), back = 0.12 * towards(angle - 90);
    diagram.polygon({centre - along, centre + along, centre + along + back, centre - along + back},
                    {ink, Weight::thin}, 0.5);
    diagram.line(centre - along, centre + along, {ink, Weight::thick});
}

}  // namespace sr
