#pragma once
/// @file form_factor_diagrams.hpp
/// Sections 8.2 and 8.3: what a form factor is made of, Nusselt's picture of it, and the hemicube's.

#include <cmath>
#include <string>

#include "course/diagram.hpp"
#include "drawing.hpp"

namespace sr {

/// Two patches, a point on each, the line between them and its angles with the normals.
inline void draw_form_factor(course::Diagram diagram) {
    const Point p{0, 0}, q{6.4, 3.4};
    diagram.polygon({{-2.4, -0.9}, {1.4, -0.9}, {2.6, 0.9}, {-1.2, 0.9}}, {Ink::blue}, 0.18);
    diagram.polygon({{5.3, 4.6}, {6.3, 1.4}, {7.6, 2.3}, {6.6, 5.5}}, {Ink::green}, 0.18);
    diagram.polygon({{-0.42, -0.16}, {0.25, -0.16}, {0.46, 0.16}, {-0.21, 0.16}}, {Ink::blue, Weight::thin},
                    0.5);
    diagram.polygon({{6.2, 3.6}, {6.38, 3.02}, {6.6, 3.17}, {6.42, 3.75}}, {Ink::green, Weight::thin}, 0.5);
    diagram.line(p, q, {Ink::vermilion, Weight::thick});
    const double line = std::atan2(3.4, 6.4) * 180 / 3.14159265358979324, normal_q = 197;
    diagram.arrow(p, {0, 3}, {Ink::blue, Weight::medium});
    diagram.arrow(q, q + 2.9 * towards(normal_q), {Ink::green, Weight::medium});
    draw_angle(diagram, p, 1.3, line, 90, "$\\theta$", 1.35);
    draw_angle(diagram, q, 1.6, normal_q, 180 + line, "$\\theta'$", 1.35);
    diagram.label({0, 3.35}, "$\\mathbf{n}$", Anchor::centre, Ink::blue);
    diagram.label(q + 3.25 * towards(normal_q), "$\\mathbf{n}'$", Anchor::centre, Ink::green);
    diagram.label({3.75, 1.55}, "$r$", Anchor::centre, Ink::vermilion);
    diagram.label({0.55, -0.4}, "$dA$", Anchor::left, Ink::blue);
    diagram.label({6.42, 2.62}, "$dA'$", Anchor::left, Ink::green);
    diagram.label({-2.0, -1.4}, "patch $i$, $A_i$", Anchor::left, Ink::blue);
    diagram.label({7.0, 5.6}, "patch $j$, $A_j$", Anchor::left, Ink::green);
}

/// In a section: a patch, its image on the unit sphere, and that image's shadow on the base.
inline void draw_nusselt(course::Diagram diagram) {
    constexpr double from = 32, to = 68, radius = 4;
    const Point      a = 7.6 * towards(from), b = 6.2 * towards(to);
    diagram.polygon({{0, 0}, a, b}, {Ink::green, Weight::thin}, 0.1);
    diagram.line(arc({0, 0}, radius, 0, 180), {Ink::black, Weight::medium});
    diagram.line({-5, 0}, {5.6, 0}, {Ink::blue, Weight::medium});
    diagram.line(a, b, {Ink::green, Weight::thick});
    diagram.line(arc({0, 0}, radius, from, to), {Ink::vermilion, Weight::thick});
    for (const double angle : {from, to}) {
        const Point on_sphere = radius * towards(angle);
        diagram.line(on_sphere, {on_sphere.x, 0}, {Ink::vermilion, Weight::thin, true});
    }
    diagram.line({radius * towards(to).x, 0}, {radius * towards(from).x, 0}, {Ink::vermilion, Weight::thick});
    diagram.point({0, 0}, {Ink::blue});
    diagram.label({0, -0.5}, "$dA$", Anchor::centre, Ink::blue);
    diagram.label((a + b) / 2.0 + Point{0.3, 0.25}, "patch $j$", Anchor::left, Ink::green);
    diagram.label(1.13 * radius * towards(49), "$\\Omega$", Anchor::centre, Ink::vermilion);
    diagram.label({2.45, -0.5}, "$\\Omega_\\perp$", Anchor::centre, Ink::vermilion);
    diagram.label({-4.1, -0.5}, "1", Anchor::centre);
    diagram.label({-9.2, 5.3}, "$F = \\Omega_\\perp / \\pi$: of the base disk,");
    diagram.label({-9.2, 4.6}, "the share below the image");
}

/// In a section: a patch under half a cube, whose pixels see other patches.
inline void draw_hemicube(course::Diagram diagram) {
    constexpr int pixels = 12;
    const Point   eye{0, 0};
    const Point   a{4.2, 5.2}, b{7.2, 2.4};
    diagram.polygon({eye, a, b}, {Ink::green, Weight::thin}, 0.1);
    diagram.line(a, b, {Ink::green, Weight::thick});
    diagram.line({-5, 0}, {5, 0}, {Ink::blue, Weight::thick});
    const auto sees = [&](Point pixel) {
        return pixel.y * b.x > pixel.x * b.y && pixel.y * a.x < pixel.x * a.y;
    };
    const auto draw = [&](Point from, Point to) {
        const Point middle = (from + to) / 2.0;
        diagram.line(
            from, to,
            {sees(middle) ? Ink::vermilion : Ink::black, sees(middle) ? Weight::thick : Weight::medium});
        const Point outwards =
            std::abs(from.x - to.x) > 0.01 ? Point{0, 0.16} : Point{from.x > 0 ? 0.16 : -0.16, 0};
        diagram.line(from - outwards, from + outwards, {Ink::black, Weight::thin});
    };
    constexpr double side = 2.4, step = 2 * side / pixels;
    for (int i = 0; i < pixels; ++i) draw({-side + i * step, side}, {-side + (i + 1) * step, side});
    for (int i = 0; i < pixels / 2; ++i)
        for (const double x : {-side, side}) draw({x, i * step}, {x, (i + 1) * step});
    diagram.point(eye, {Ink::blue});
    diagram.label({0, -0.5}, "middle of patch $i$", Anchor::centre, Ink::blue);
    diagram.label((a + b) / 2.0 + Point{0.3, 0.3}, "patch $j$", Anchor::left, Ink::green);
    diagram.label({-2.7, 2.9}, "pixels, each worth $\\Delta F$", Anchor::right);
    diagram.label({1.2, 3.0}, "$\\Sigma\\, \\Delta F$", Anchor::right, Ink::vermilion);
}

}  // namespace sr
