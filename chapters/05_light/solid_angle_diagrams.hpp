#pragma once
/// @file solid_angle_diagrams.hpp
/// Solid angles, finite and infinitesimal, and what hides a part of them.

#include "course/chapter.hpp"
#include "drawing.hpp"

namespace sr {

/// A sphere around c with a cap of it marked, at the right.
inline void draw_cap(course::Diagram diagram, double radius, Ink ink) {
    constexpr double half = 24, tilt = 20;  // of the cone, and of its axis [deg]
    const auto       turned = [](Point p) { return p.x * towards(tilt) + p.y * towards(tilt + 90); };
    const Point      rim    = turned({radius * towards(half).x, 0});
    const Point      across = turned({0, radius * towards(half).y}),
                thin        = turned({0.25 * radius * towards(half).y, 0});
    diagram.line(arc({0, 0}, radius, 0, 360), {Ink::grey});
    auto       outside = arc({0, 0}, radius, tilt - half, tilt + half);
    const auto inside  = ellipse(rim, thin, across, 90, 270);
    auto       cap     = outside;
    cap.insert(cap.end(), inside.begin(), inside.end());
    diagram.polygon(cap, {ink, Weight::thin}, 0.45);
    diagram.line(ellipse(rim, thin, across, -90, 90), {ink, Weight::thin});
    diagram.line(outside, {ink, Weight::thick});
}

/// Figure 5.2: the share of the directions is the same on every sphere.
inline void draw_solid_angle(course::Diagram diagram) {
    constexpr double half = 24, tilt = 20;
    draw_cap(diagram, 4.6, Ink::green);
    draw_cap(diagram, 2.4, Ink::blue);
    for (const double angle : {tilt - half, tilt + half})
        diagram.line({0, 0}, 5.6 * towards(angle), {Ink::vermilion, Weight::medium});
    diagram.point({0, 0});
    diagram.label({-0.25, -0.1}, "$\\mathbf{c}$", Anchor::right);
    diagram.label(1.15 * towards(tilt), "$\\Omega$", Anchor::centre, Ink::vermilion);
    diagram.arrow({0, 0}, 2.4 * towards(130), {Ink::blue, Weight::thin});
    diagram.arrow({0, 0}, 4.6 * towards(165), {Ink::green, Weight::thin});
    diagram.label(1.5 * towards(118), "$r_1$", Anchor::centre, Ink::blue);
    diagram.label(3.4 * towards(160), "$r_2$", Anchor::centre, Ink::green);
    diagram.label(2.75 * towards(tilt - half) + Point{0.15, -0.5}, "$A_1$", Anchor::centre, Ink::blue);
    diagram.label(4.9 * towards(tilt - half) + Point{0.4, -0.4}, "$A_2$", Anchor::centre, Ink::green);
    diagram.label({6.6, 2.4}, "$\\Omega = A_1 / r_1^2 = A_2 / r_2^2$");
    diagram.label({6.6, 1.4}, "all directions: $4\\pi$");
    diagram.label({6.6, 0.6}, "half of them: $2\\pi$");
}

/// Figure 5.3: a small area, turned away by an angle.
inline void draw_small_area(course::Diagram diagram) {
    const Point      c{0, 0}, x{8, 1.2};
    const double     sight = degrees(std::atan2(x.y, x.x));
    constexpr double turn = 40, half = 1.35;
    const double     along = sight + 90 - turn;  // of the area itself
    const double     wide  = half * std::cos(radians(turn));
    const Point      edge = half * towards(along), seen = wide * towards(sight + 90);
    diagram.polygon({c, x - edge, x + edge}, {Ink::vermilion, Weight::thin}, 0.12);
    diagram.line(x - seen, x + seen, {Ink::green, Weight::thick, true});
    draw_surface(diagram, x, half, along, Ink::blue);
    diagram.line(c, x, {Ink::black, Weight::thin, true});
    diagram.arrow(x, x + 2.2 * towards(along + 90), {Ink::blue});
    draw_angle(diagram, x, 1.35, along + 90, sight + 180, "$\\theta'$");
    diagram.line(arc(c, 2.4, sight - 8.2, sight + 7.3), {Ink::vermilion, Weight::thick});
    diagram.point(c);
    diagram.label(c + Point{-0.25, 0}, "$\\mathbf{c}$", Anchor::right);
    diagram.label({2.1, 0.95}, "$d\\omega$", Anchor::centre, Ink::vermilion);
    diagram.label({4.6, 0.42}, "$r$", Anchor::centre);
    diagram.label(x + edge + Point{0.25, 0.1}, "$dA$", Anchor::left, Ink::blue);
    diagram.label(x + 2.45 * towards(along + 90), "$\\mathbf{n}$", Anchor::centre, Ink::blue);
    diagram.label(x - seen + Point{0.9, -0.45}, "$dA\\, \\cos\\theta'$", Anchor::centre, Ink::green);
    diagram.label({0, 2.6}, "$d\\omega = dA\\, \\cos\\theta' / r^2$");
}

/// Figure 5.6: three points of a surface, one of which is seen.
inline void draw_visibility(course::Diagram diagram) {
    const Point c{0, 0};
    // a body whose front is seen, and something before it
    diagram.polygon(ellipse({10, 0}, {1.6, 0}, {0, 2.6}), {Ink::grey, Weight::medium}, 0.25);
    diagram.polygon(ellipse({5, -1.35}, {0.55, 0}, {0, 0.85}), {Ink::blue, Weight::medium}, 0.35);
    const Point x1 = Point{10, 0} + Point{-1.6 * towards(40).x, 2.6 * towards(40).y};
    const Point x2 = Point{10, 0} + Point{-1.6 * towards(50).x, -2.6 * towards(50).y};
    const Point x3{11.6, 0};
    diagram.line(c, x1, {Ink::green, Weight::thick});
    const Point stop = 0.497 * x2;
    diagram.line(c, stop, {Ink::vermilion, Weight::thick});
    diagram.line(stop, x2, {Ink::vermilion, Weight::thin, true});
    diagram.line(c, {8.4, 0}, {Ink::vermilion, Weight::thick});
    diagram.line({8.4, 0}, x3, {Ink::vermilion, Weight::thin, true});
    diagram.point(c);
    for (const auto& [p, ink] : {std::pair{x1, Ink::green}, {x2, Ink::vermilion}, {x3, Ink::vermilion}})
        diagram.point(p, {ink});
    diagram.label({-0.25, 0}, "$\\mathbf{c}$", Anchor::right);
    diagram.label(x1 + Point{-0.1, 0.5}, "$\\mathbf{x}_1$", Anchor::right, Ink::green);
    diagram.label(x2 + Point{-0.1, -0.5}, "$\\mathbf{x}_2$", Anchor::right, Ink::vermilion);
    diagram.label(x3 + Point{0.3, 0}, "$\\mathbf{x}_3$", Anchor::left, Ink::vermilion);
    diagram.label({3.3, 1.5}, "$V(\\mathbf{c}, \\mathbf{x}_1) = 1$", Anchor::centre, Ink::green);
    diagram.label({1.2, -2.0}, "$V(\\mathbf{c}, \\mathbf{x}_2) = 0$", Anchor::left, Ink::vermilion);
    diagram.label({12.4, -1.0}, "$V(\\mathbf{c}, \\mathbf{x}_3) = 0$", Anchor::left, Ink::vermilion);
}

}  // namespace sr
