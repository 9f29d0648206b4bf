#pragma once
/// @file curves.hpp
/// Round lines for a diagram, and the angles that they mark.

#include <cmath>
#include <string>
#include <vector>

#include "course/diagram.hpp"
#include "math/degrees.hpp"

namespace sr::course {

/// The unit vector at an angle [deg], counted from the right.
[[nodiscard]] inline Point towards(double angle) {
    return {std::cos(radians(angle)), std::sin(radians(angle))};
}

/// A part of an ellipse with the given half-axes, from one angle [deg] to another.
[[nodiscard]] inline std::vector<Point> ellipse(Point centre, Point a, Point b, double from = 0,
                                                double to = 360) {
    std::vector<Point> points;
    for (int i = 0; i <= 96; ++i) {
        const Point p = towards(from + (to - from) * i / 96);
        points.push_back(centre + p.x * a + p.y * b);
    }
    return points;
}

[[nodiscard]] inline std::vector<Point> arc(Point centre, double radius, double from = 0, double to = 360) {
    return ellipse(centre, {radius, 0}, {0, radius}, from, to);
}

/// A thin arc with a name in its middle: an angle.
inline void draw_angle(Diagram diagram, Point at, double radius, double from, double to,
                       const std::string& name, double name_at = 1.3) {
    diagram.line(arc(at, radius, from, to), {Ink::black, Weight::thin});
    diagram.label(at + name_at * radius * towards((from + to) / 2), name, Anchor::centre);
}

}  // namespace sr::course
