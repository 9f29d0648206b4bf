#pragma once
/// @file radiance_diagrams.hpp
/// Radiance in a cone, what turning a surface does to it, and radiance between two patches.

#include "course/chapter.hpp"
#include "drawing.hpp"

namespace sr {

/// Figure 5.8: a thin cone of directions from a small area.
inline void draw_radiance_cone(course::Diagram diagram) {
    const Point      x{0, 0};
    constexpr double half = 1.7, theta = 38, omega = 90 - theta, spread = 7, length = 6;
    for (const double from : {-1.0, 0.0, 1.0}) {
        const Point start = x + Point{half * from, 0};
        diagram.polygon(
            {start, start + length * towards(omega - spread), start + length * towards(omega + spread)},
            {Ink::vermilion, Weight::thin}, 0.13);
    }
    diagram.line({half, 0}, Point{half, 0} + 2 * half * std::cos(radians(theta)) * towards(omega + 90),
                 {Ink::green, Weight::thick, true});
    draw_surface(diagram, x, half, 0, Ink::blue);
    diagram.arrow(x, {0, 4.6}, {Ink::blue});
    diagram.arrow(x, length * towards(omega), {Ink::vermilion, Weight::thick});
    draw_angle(diagram, x, 2.6, omega, 90, "$\\theta$", 1.15);
    diagram.line(arc(x, 5, omega - spread, omega + spread), {Ink::vermilion, Weight::medium});
    diagram.point(x);
    diagram.label({0, 4.95}, "$\\mathbf{n}$", Anchor::centre, Ink::blue);
    diagram.label(length * towards(omega) + Point{0, 0.8}, "$\\omega$, within $d\\omega$", Anchor::centre,
                  Ink::vermilion);
    diagram.label({-half - 0.2, 0.05}, "$dA$", Anchor::right, Ink::blue);
    diagram.label({6.6, 1.9}, "$L = d^2\\Phi / (dA\\, \\cos\\theta\\, d\\omega)$");
    diagram.label({6.6, 0.9}, "$dA\\, \\cos\\theta$: what $\\omega$ sees of $dA$", Anchor::left, Ink::green);
}

/// Figure 5.9: the same light on two areas, one facing it and one turned.
inline void draw_oriented_surfaces(course::Diagram diagram) {
    constexpr double half = 1.3, turn = 50;
    const double     left = -half, right = half;
    for (const auto& [offset, tilt] : {std::pair{0.0, 0.0}, {9.0, turn}}) {
        const double longer = half / std::cos(radians(tilt)), rise = half * std::tan(radians(tilt));
        diagram.polygon(
            {{offset + left, 4.2}, {offset + right, 4.2}, {offset + right, rise}, {offset + left, -rise}},
            {Ink::vermilion, Weight::thin}, 0.13);
        for (const double x : {-1.0, 0.5, 1.0}) {
            const double y = x * std::tan(radians(tilt));
            diagram.arrow({offset + x, 4.0}, {offset + x, y + 0.1}, {Ink::vermilion, Weight::medium});
        }
        draw_surface(diagram, {offset, 0}, longer, tilt, Ink::blue);
        diagram.arrow({offset, 0}, Point{offset, 0} + 2.4 * towards(90 + tilt), {Ink::blue});
        diagram.label(Point{offset, 0} + 2.75 * towards(90 + tilt), "$\\mathbf{n}$", Anchor::centre,
                      Ink::blue);
        if (tilt == 0) continue;
        diagram.line({offset, 0}, {offset, 2.4}, {Ink::black, Weight::thin, true});
        draw_angle(diagram, {offset, 0}, 1.6, 90, 90 + tilt, "$\\theta$", 0.7);
    }
    diagram.label({-1.6, -0.1}, "$dA_1$", Anchor::right, Ink::blue);
    diagram.label({9 - 1.7, -1.25}, "$dA_2 = dA_1 / \\cos\\theta$", Anchor::right, Ink::blue);
    diagram.label({4.5, 3.7}, "the same $d\\Phi$", Anchor::centre, Ink::vermilion);
    diagram.label({0, -2.4}, "$E_1 = d\\Phi / dA_1$", Anchor::centre);
    diagram.label({9.6, -2.4}, "$E_2 = d\\Phi / dA_2 = E_1 \\cos\\theta$", Anchor::centre);
    diagram.label({4.8, -3.3}, "radiance: the same for both", Anchor::centre, Ink::vermilion);
}

/// Figure 5.11: two patches that see each other.
inline void draw_two_patches(course::Diagram diagram) {
    const Point      x1{0, 0}, x2{9, 1.5};
    const double     sight = degrees(std::atan2(x2.y, x2.x));
    constexpr double half1 = 1.3, half2 = 1.0;
    const double     n1 = sight + 35, n2 = sight + 180 - 28;  // normals [deg]
    const Point      edge1 = half1 * towards(n1 - 90), edge2 = half2 * towards(n2 - 90);
    diagram.polygon({x1, x2 - edge2, x2 + edge2}, {Ink::blue, Weight::thin}, 0.16);
    diagram.polygon({x2, x1 - edge1, x1 + edge1}, {Ink::green, Weight::thin}, 0.16);
    diagram.line(x1, x2, {Ink::black, Weight::thin, true});
    draw_surface(diagram, x1, half1, n1 - 90, Ink::blue);
    draw_surface(diagram, x2, half2, n2 - 90, Ink::green);
    diagram.arrow(x1, x1 + 2.3 * towards(n1), {Ink::blue});
    diagram.arrow(x2, x2 + 2.3 * towards(n2), {Ink::green});
    draw_angle(diagram, x1, 1.5, sight, n1, "$\\theta_1$", 1.35);
    draw_angle(diagram, x2, 1.5, n2, sight + 180, "$\\theta_2$", 1.35);
    diagram.label(x1 - edge1 + Point{-0.3, 0.25}, "$dA_1$", Anchor::right, Ink::blue);
    diagram.label(x2 + edge2 + Point{0.3, 0.1}, "$dA_2$", Anchor::left, Ink::green);
    diagram.label({5.3, 0.6}, "$r$", Anchor::centre);
    diagram.label({3.2, -1.9}, "$d\\omega_1 = dA_2\\, \\cos\\theta_2 / r^2$", Anchor::left, Ink::blue);
    diagram.label({3.2, -2.8}, "$d\\omega_2 = dA_1\\, \\cos\\theta_1 / r^2$", Anchor::left, Ink::green);
    diagram.label({4.9, 4.0},
                  "$L\\, dA_1\\, \\cos\\theta_1\\, d\\omega_1 = L\\, dA_2\\, \\cos\\theta_2\\, d\\omega_2$",
                  Anchor::centre);
}

}  // namespace sr
