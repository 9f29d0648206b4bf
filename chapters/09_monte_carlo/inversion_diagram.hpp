#pragma once
/// @file inversion_diagram.hpp
/// Figure 9.6: a density, its integral and the inverse of that, with unit numbers on their way.

#include <cmath>
#include <functional>
#include <numbers>
#include <string>
#include <vector>

#include "course/diagram.hpp"

namespace sr {

/// The angle to the pole that uniform directions of a sphere have: p = sin(theta) / 2, P = (1 - cos(theta)) / 2.
[[nodiscard]] inline double angle_to_pole(double u) {
    return std::acos(1 - 2 * u);
}

/// What an axis shows, and what stands at its end, three units from the origin.
struct NamedAxis {
    std::string name, end;
};

/// Axes of a picture 3 wide and 3 high, and its curve.
/// @param curve  [0, 1] -> [0, 1], shares of both axes
inline void draw_function(course::Diagram diagram, course::Point at, const NamedAxis& x, const NamedAxis& y,
                          const std::function<double(double)>& curve) {
    using course::Point;
    diagram.arrow(at, at + Point{3.3, 0}, {course::Ink::grey});
    diagram.arrow(at, at + Point{0, 3.4}, {course::Ink::grey});
    diagram.label(at + Point{1.5, -0.25}, x.name, course::Anchor::centre, course::Ink::grey);
    diagram.label(at + Point{3, -0.25}, x.end, course::Anchor::centre, course::Ink::grey);
    diagram.label(at + Point{0.15, 3.4}, y.name, course::Anchor::left);
    diagram.label(at + Point{-0.12, 3}, y.end, course::Anchor::right, course::Ink::grey);
    std::vector<Point> points;
    for (int i = 0; i <= 240; ++i) points.push_back(at + Point{3 * i / 240.0, 3 * curve(i / 240.0)});
    diagram.line(points, {course::Ink::black, course::Weight::thick});
}

/// Ten numbers, equally far apart, become ten angles, which are close together where the density is large.
inline void draw_inversion(course::Diagram diagram) {
    using course::Ink;
    using course::Point;
    constexpr double pi = std::numbers::pi;
    const Point      density{0, 0}, cumulative{4.1, 0}, inverse{8.2, 0};
    for (int i = 0; i < 10; ++i) {
        const double      u = (i + 0.5) / 10, x = angle_to_pole(u) / pi;
        const bool        followed = i == 2;
        const course::Pen pen{followed ? Ink::vermilion : Ink::blue,
                              followed ? course::Weight::medium : course::Weight::thin};
        const auto last = [&](Point from, Point to) {
            followed ? diagram.arrow(from, to, pen) : diagram.line(from, to, pen);
        };
        diagram.line(density + Point{3 * x, 0}, density + Point{3 * x, 3 * std::sin(pi * x)}, pen);
        diagram.line(cumulative + Point{0, 3 * u}, cumulative + Point{3 * x, 3 * u}, pen);
        last(cumulative + Point{3 * x, 3 * u}, cumulative + Point{3 * x, 0});
        diagram.line(inverse + Point{3 * u, 0}, inverse + Point{3 * u, 3 * x}, pen);
        last(inverse + Point{3 * u, 3 * x}, inverse + Point{0, 3 * x});
    }
    const NamedAxis x{"$x$", "$\\pi$"};
    draw_function(diagram, density, x, {"$p(x)$", "½"}, [](double t) { return std::sin(pi * t); });
    draw_function(diagram, cumulative, x, {"$P(x)$", "1"},
                  [](double t) { return (1 - std::cos(pi * t)) / 2; });
    draw_function(diagram, inverse, {"$\\xi$", "1"}, {"$P^{-1}(\\xi)$", "$\\pi$"},
                  [](double u) { return angle_to_pole(u) / pi; });
}

}  // namespace sr
