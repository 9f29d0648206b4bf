#pragma once
/// @file flux_diagram.hpp

#include "course/chapter.hpp"
#include "drawing.hpp"

namespace sr {

/// A surface in perspective with a small piece of it marked: flux arrives there, or leaves.
inline void draw_flux_density_panel(course::Diagram diagram, Point origin, bool arrives) {
    const Point right{1, 0.12}, back{0.55, 0.6};
    const auto  at = [&](double x, double y) { return origin + x * right + y * back; };
    diagram.polygon({at(-3, -1.6), at(3, -1.6), at(3, 1.6), at(-3, 1.6)}, {Ink::grey, Weight::thin}, 0.15);
    diagram.polygon({at(-1, -0.8), at(1, -0.8), at(1, 0.8), at(-1, 0.8)}, {Ink::blue, Weight::medium}, 0.45);
    for (const double angle : {50.0, 70.0, 90.0, 112.0, 132.0}) {
        const Point foot = at((90 - angle) / 55, 0.4 * (angle - 90) / 40);
        const Point tip  = foot + 2.5 * towards(angle);
        const Point near = foot + 0.22 * towards(angle);
        diagram.arrow(arrives ? tip : near, arrives ? near : tip, {Ink::vermilion, Weight::thick});
    }
    diagram.label(at(0, 0) + Point{0, 3.15}, arrives ? "$d\\Phi$ arrives" : "$d\\Phi$ leaves", Anchor::centre,
                  Ink::vermilion);
    diagram.label(at(1.2, 0.4), "$dA$", Anchor::left, Ink::blue);
    diagram.label(at(0, -1.6) + Point{0, -0.75},
                  arrives ? "irradiance $E = d\\Phi / dA$" : "radiosity $B = d\\Phi / dA$", Anchor::centre);
}

/// Figure 5.1.
inline void draw_flux_density(const course::Diagram& diagram) {
    draw_flux_density_panel(diagram, {0, 0}, true);
    draw_flux_density_panel(diagram, {9, 0}, false);
}

}  // namespace sr
