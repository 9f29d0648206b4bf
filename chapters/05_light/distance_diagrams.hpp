#pragma once
/// @file distance_diagrams.hpp
/// What distance does to irradiance, and does not do to radiance.

#include "course/chapter.hpp"
#include "drawing.hpp"

namespace sr {

/// A square that faces the lamp, seen obliquely, in n x n tiles.
inline void draw_tiles(course::Diagram diagram, Point centre, double side, int n, Ink ink) {
    const Point up{0, 1}, across{0.42, 0.28};
    const auto  at = [&](double x, double y) { return centre + side * (x * across + y * up); };
    for (int i = 0; i < n; ++i) {
        for (int j = 0; j < n; ++j) {
            const double x0 = double(i) / n - 0.5, y0 = double(j) / n - 0.5, d = 1.0 / n;
            diagram.polygon({at(x0, y0), at(x0 + d, y0), at(x0 + d, y0 + d), at(x0, y0 + d)},
                            {ink, Weight::medium}, 0.3);
        }
    }
}

/// Figure 5.13: the same flux on one tile, on four, on nine.
inline void draw_inverse_square(course::Diagram diagram) {
    const Point  lamp{0, 0};
    const double first = 3.4, side = 1.5;
    for (int k = 3; k >= 1; --k)
        draw_tiles(diagram, {k * first, 0}, k * side, k,
                   k == 1   ? Ink::blue
                   : k == 2 ? Ink::green
                            : Ink::purple);
    for (const double x : {-0.5, 0.5}) {
        for (const double y : {-0.5, 0.5})
            diagram.line(lamp, Point{3 * first, 0} + 3 * side * Point{0.42 * x, 0.28 * x + y},
                         {Ink::vermilion, Weight::thin});
    }
    diagram.polygon(arc(lamp, 0.28), {Ink::vermilion}, 0.8);
    diagram.label({0, -0.75}, "lamp", Anchor::centre, Ink::vermilion);
    for (int k = 1; k <= 3; ++k) {
        const std::string names[] = {"$r$: $E$", "$2r$: $E/4$", "$3r$: $E/9$"};
        diagram.label({k * first, -3.6}, names[k - 1], Anchor::centre,
                      k == 1   ? Ink::blue
                      : k == 2 ? Ink::green
                               : Ink::purple);
    }
}

/// Figure 5.16: a surface gathers light from its lamp; a sensor element looks through a hole at what it sees.
inline void draw_sensor(course::Diagram diagram) {
    // left: two surfaces before a lamp
    const Point lamp{0, 0};
    for (const auto& [distance, ink] : {std::pair{2.6, Ink::blue}, {5.2, Ink::green}}) {
        diagram.polygon({lamp, {distance, 0.8}, {distance, -0.8}}, {ink, Weight::thin}, 0.14);
        draw_surface(diagram, {distance, 0}, 0.8, 90, ink);
    }
    diagram.polygon(arc(lamp, 0.3), {Ink::vermilion}, 0.8);
    diagram.label({0, -0.8}, "lamp", Anchor::centre, Ink::vermilion);
    diagram.label({2.6, -1.75}, "$E$", Anchor::centre, Ink::blue);
    diagram.label({5.2, -1.75}, "$E/4$", Anchor::centre, Ink::green);
    diagram.label({2.6, -2.6}, "a surface: irradiance", Anchor::centre);
    // right: one element of a sensor behind a hole
    const Point hole{10.6, 0};
    const auto  through = [&](double x) { return 0.22 * (x - hole.x); };
    diagram.polygon({hole, {17.2, through(17.2)}, {17.2, -through(17.2)}}, {Ink::vermilion, Weight::thin},
                    0.14);
    diagram.polygon({hole, {9.2, through(9.2)}, {9.2, -through(9.2)}}, {Ink::vermilion, Weight::thin}, 0.14);
    for (const double end : {-1.0, 1.0})
        diagram.line({hole.x, 0.12 * end}, {hole.x, 1.4 * end}, {Ink::black, Weight::thick});
    diagram.line({9.2, -0.31}, {9.2, 0.31}, {Ink::black, Weight::thick});
    for (const auto& [x, ink] : {std::pair{13.2, Ink::blue}, {15.8, Ink::green}})
        diagram.line({x, through(x)}, {x, -through(x)}, {ink, Weight::thick});
    diagram.label({13.2, -1.75}, "$L$", Anchor::centre, Ink::blue);
    diagram.label({15.8, -1.75}, "$L$", Anchor::centre, Ink::green);
    diagram.label({8.9, 0}, "pixel", Anchor::right);
    diagram.label({12.6, -2.6}, "a sensor element: radiance", Anchor::centre);
}

}  // namespace sr
