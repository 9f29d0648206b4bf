#pragma once
/// @file surfaces_diagram.hpp

#include <cmath>

#include "course/chapter.hpp"
#include "drawing.hpp"

namespace sr {

/// A point, its normal and a cone of directions that are summed up.
inline void draw_directions(course::Diagram diagram, Point p, double omega, Point left, Point right) {
    diagram.polygon({p, left, right}, {Ink::vermilion, Weight::thin}, 0.2);
    diagram.arrow(p, p + Point{0, 2.6}, {Ink::blue});
    draw_angle(diagram, p, 1.5, omega, 90, "$\\theta$", 1.27);
    diagram.label(p + Point{0, 2.95}, "$\\mathbf{n}_p$", Anchor::centre, Ink::blue);
    diagram.label(p + Point{0, -0.55}, "$p$", Anchor::centre);
}

/// The surfaces that the directions end on.
inline void draw_room_of_surfaces(course::Diagram diagram, Point p) {
    const Point  x = p + Point{4.2, 4.6}, hidden = p + Point{6.4, 1.1};
    const double sight = degrees(std::atan2(4.6, 4.2));
    draw_directions(diagram, p, sight, x - Point{0.8, 0}, x + Point{0.8, 0});
    diagram.line({p + Point{-2.6, 0}, p + Point{6.4, 0}, p + Point{6.4, 4.6}, p + Point{-2.6, 4.6}},
                 {Ink::grey, Weight::thick});
    diagram.polygon({p + Point{4.1, 0}, p + Point{5.4, 0}, p + Point{5.4, 1.7}, p + Point{4.1, 1.7}},
                    {Ink::grey, Weight::medium}, 0.3);
    diagram.line(x - Point{0.8, 0}, x + Point{0.8, 0}, {Ink::green, Weight::thick});
    diagram.line(p, x, {Ink::black, Weight::thin, true});
    diagram.arrow(x, x - Point{0, 2}, {Ink::green});
    diagram.line(arc(x, 1.2, sight + 180, 270), {Ink::black, Weight::thin});
    diagram.point(x, {Ink::green});
    const Point stop = p + 4.1 / 6.4 * (hidden - p);
    diagram.line(p, stop, {Ink::vermilion, Weight::medium});
    diagram.line(stop, hidden, {Ink::vermilion, Weight::thin, true});
    diagram.point(hidden, {Ink::vermilion});
    diagram.point(p);
    diagram.label(x + Point{0, 0.5}, "$dA_x$", Anchor::centre, Ink::green);
    diagram.label(x + Point{0.3, -1.7}, "$\\mathbf{n}_x$", Anchor::left, Ink::green);
    diagram.label(x + Point{-0.6, -1.95}, "$\\theta_x$", Anchor::centre);
    diagram.label(p + Point{1.6, 2.9}, "$r_{px}$", Anchor::right);
    diagram.label(hidden + Point{0.25, 0}, "$V = 0$", Anchor::left, Ink::vermilion);
    diagram.label(p + Point{1.9, -1.5}, "$d\\omega = V\\, \\cos\\theta_x\\, dA_x / r_{px}^2$",
                  Anchor::centre);
}

/// The hemisphere of directions at a point becomes the surfaces of the scene.
inline void draw_surfaces(course::Diagram diagram) {
    const Point p{0, 0};
    diagram.line(arc(p, 3.6, 0, 180), {Ink::grey});
    draw_directions(diagram, p, 47.6, 3.6 * towards(52.8), 3.6 * towards(42.4));
    diagram.line(arc(p, 3.6, 42.4, 52.8), {Ink::vermilion, Weight::thick});
    diagram.line(p - Point{3.9, 0}, p + Point{3.9, 0}, {Ink::grey, Weight::thick});
    diagram.point(p);
    diagram.label(3.6 * towards(47.6) + Point{0.35, 0.35}, "$d\\omega$", Anchor::left, Ink::vermilion);
    diagram.label({0, -1.5}, "all directions $\\omega$", Anchor::centre);
    draw_room_of_surfaces(diagram, {9.2, 0});
}

}  // namespace sr
