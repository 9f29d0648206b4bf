#pragma once
/// @file optics_diagrams.hpp
/// The drawings of sections 7.6 and 7.7: rays as the optical bench traced them.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "course/chapter.hpp"
#include "math/degrees.hpp"
#include "optics.hpp"
#include "tree_diagram.hpp"

namespace sr {

/// All of a path, the last ray `length` long.
inline void draw_path(course::Diagram diagram, const LightPath& path, double length, course::Pen pen) {
    std::vector<course::Point> points;
    for (const auto& ray : path) points.push_back(on_paper(ray.origin));
    points.push_back(on_paper(path.back().at(length)));
    diagram.line(points, pen);
}

/// A prism that turns five rays; the one whose way is symmetric, least.
inline void draw_prism(course::Diagram diagram, const Prism& prism, double symmetric) {
    using course::Ink;
    const double base = 2.0, half = base * std::tan(prism.A / 2);
    diagram.polygon({{0, 1}, {-half, 1 - base}, {half, 1 - base}}, {Ink::sky}, 0.18);
    const auto draw = [&](double incidence, course::Pen pen) {
        if (auto path = prism.trace(incidence)) {
            path->front() = {path->front().at(-0.6), path->front().direction};
            draw_path(diagram, *path, 1.9, pen);
        }
    };
    for (const double incidence : {32.0, 38.0, 60.0, 72.0})
        draw(radians(incidence), {Ink::blue, course::Weight::thin});
    draw(symmetric, {Ink::vermilion, course::Weight::thick});

    // by how much: from the way that the ray would have gone to the one that it goes
    const auto   path = *prism.trace(symmetric);
    const auto   exit = on_paper(path[2].origin);
    const double to = std::atan2(path[2].direction.y, path[2].direction.x), turned = deviation(path);
    diagram.line(exit, exit + 1.9 * on_paper(heading(to + turned)),
                 {Ink::grey, course::Weight::medium, true});
    std::vector<course::Point> arc;
    for (int i = 0; i <= 20; ++i) arc.push_back(exit + 1.6 * on_paper(heading(to + turned * i / 20)));
    diagram.line(arc, {Ink::vermilion});
    diagram.label(exit + 2.1 * on_paper(heading(to + turned / 2)),
                  fmt::format("$\\delta = {:.1f}^\\circ$", degrees(turned)), course::Anchor::left,
                  Ink::vermilion);
    diagram.label({0, 0.62}, fmt::format("${:.0f}^\\circ$", degrees(prism.A)), course::Anchor::centre);
}

/// A length below a drawing, from x to another, with its name; dashed lines lead down to both ends from y.
inline void draw_length(course::Diagram diagram, Interval<double> x, double y, double below,
                        const std::string& name) {
    using course::Ink;
    for (const double end : {x.min, x.max})
        diagram.line({end, y}, {end, below}, {Ink::grey, course::Weight::thin, true});
    diagram.line({x.min, below}, {x.max, below});
    diagram.label({(x.min + x.max) / 2, below - 0.13}, name, course::Anchor::centre);
}

/// The rays of a lamp under water at these angles: out of it, or reflected totally. Where they seem to come from is
/// dashed.
inline void draw_from_under_water(course::Diagram diagram, const Vector3<double>& lamp, double n,
                                  const std::vector<double>& angles) {
    using course::Ink;
    const Plane<double> level{{0, 0, 0}, {0, 1, 0}};
    for (const double angle : angles) {
        const Ray<double> ray{lamp, {std::sin(angle), std::cos(angle), 0}};
        const auto        point = surface_point(level, ray, intersect(level, ray).value_or(0));
        const auto        out   = refracted(ray, point, n);
        const course::Pen pen{out ? Ink::blue : Ink::vermilion};
        diagram.line(on_paper(lamp), on_paper(point.position), pen);
        const auto on = out ? *out : reflected(ray, point);
        diagram.arrow(on_paper(point.position), on_paper(on.at(out ? 1.2 : 0.6)), pen);
        if (out && angle != 0)  // drawn on below, to where it passes over the point
            diagram.line(on_paper(point.position), on_paper(out->at(-out->origin.x / out->direction.x)),
                         {Ink::grey, course::Weight::medium, true});
    }
}

/// Light from a point under water: what leaves it, drawn at the right, and what is reflected totally, at the left.
inline void draw_water(course::Diagram diagram, double n) {
    using course::Ink;
    const Vector3<double> lamp{0, -1, 0};
    diagram.polygon({{-2.65, 0}, {2.65, 0}, {2.65, -1.25}, {-2.65, -1.25}}, {Ink::sky, course::Weight::thin},
                    0.18);
    draw_from_under_water(diagram, lamp, n,
                          {radians(-64), radians(-56), 0, radians(18), radians(33), radians(45)});
    const double edge = critical_angle(n), half = std::tan(edge);
    for (const double x : {-half, half}) diagram.line(on_paper(lamp), {x, 0}, {Ink::green});
    diagram.line({-half, 0}, {half, 0}, {Ink::green, course::Weight::thick});
    std::vector<course::Point> arc;
    for (int i = -20; i <= 20; ++i)
        arc.push_back(on_paper(lamp + 0.35 * heading(std::numbers::pi / 2 + edge * i / 20)));
    diagram.line(arc, {Ink::green});
    diagram.point(on_paper(lamp));
    diagram.label({-0.3, -0.5}, fmt::format("${:.1f}^\\circ$", 2 * degrees(edge)), course::Anchor::centre,
                  Ink::green);
    diagram.label({-0.1, 0.14}, "Snell's window", course::Anchor::right, Ink::green);
    diagram.label({-2.5, 0.14}, "air");
    diagram.label({2.55, -0.14}, "water", course::Anchor::right, Ink::sky);
    diagram.label({-1.35, -1.1}, "reflected totally", course::Anchor::centre, Ink::vermilion);
}

/// How far a ray goes before it is off a paper that ends at x and at +-y.
[[nodiscard]] inline double length_on_paper(const Ray<double>& ray, double x, double y) {
    const auto& [o, d] = ray;
    return std::min((x - o.x) / d.x, d.y == 0 ? HUGE_VAL : (std::copysign(y, d.y) - o.y) / d.y);
}

/// Parallel rays through a ball of glass, and what they have in place of a focus.
inline void draw_ball_lens(course::Diagram diagram, double n) {
    using course::Ink;
    diagram.polygon(circle({0, 0}, 1), {Ink::sky}, 0.18);
    diagram.line({-2.2, 0}, {3.4, 0}, {Ink::grey, course::Weight::thin, true});
    for (int i = -19; i <= 19; ++i) {
        const double h    = 0.05 * i;
        auto         path = through_ball({{-2.2, h == 0 ? 1e-9 : h, 0}, {1, 0, 0}}, {{0, 0, 0}, 1}, n);
        if (!path) continue;
        draw_path(diagram, *path, length_on_paper(path->back(), 3.4, 1.25),
                  {std::abs(i) <= 4 ? Ink::vermilion : Ink::blue, course::Weight::thin});
    }
    const double f = n / (2 * (n - 1));
    diagram.point({0, 0}, {Ink::grey});
    diagram.point({f, 0});
    draw_length(diagram, {0, 1}, 0, -1.45, "$r$");
    draw_length(diagram, {0, f}, 0, -1.85, "$f$");
    diagram.label({-0.08, -1.85}, "centre", course::Anchor::right);
    diagram.label({f + 0.08, -1.85}, "focus");
}

/// Parallel rays off a hollow mirror, seen from the side.
inline void draw_hollow_mirror(course::Diagram diagram) {
    using course::Ink;
    std::vector<course::Point> arc;
    for (double angle = -80; angle <= 80; angle += 2) arc.push_back(on_paper(heading(radians(angle))));
    for (int i = -19; i <= 19; ++i) {
        const double h    = i == 0 ? 1e-9 : 0.05 * i;
        const auto   back = off_hollow_mirror(h, 1).back();
        if (i % 2 == 0) diagram.arrow({-1, h}, {-0.7, h}, {Ink::grey, course::Weight::thin});
        // to the mirror's other side, or to the left end of the paper
        double length = intersect(Sphere<double>{{0, 0, 0}, 1}, back).value_or(1);
        if (back.direction.x < 0) length = std::min(length, length_on_paper(back, -0.6, 1));
        diagram.line(on_paper(back.origin), on_paper(back.at(length)),
                     {std::abs(i) <= 4 ? Ink::vermilion : Ink::blue, course::Weight::thin});
    }
    diagram.line(arc, {Ink::black, course::Weight::thick});
    diagram.point({0.5, 0});
    diagram.point({0, 0}, {Ink::grey});
    draw_length(diagram, {0, 0.5}, 0, -1.15, "$r/2$");
    draw_length(diagram, {0, 1}, 0, -1.5, "$r$");
    diagram.label({-0.05, -1.15}, "centre", course::Anchor::right);
    diagram.label({0.55, -1.15}, "focus");
}

/// Sunlight through a drop of water, reflected once: most of it leaves near one direction.
inline void draw_rainbow(course::Diagram diagram, double n, double bundled) {
    using course::Ink;
    diagram.polygon(circle({0, 0}, 1), {Ink::sky}, 0.18);
    const auto draw = [&](double b, course::Pen pen) {
        if (auto path = through_drop(b, n)) {
            path->front().origin.x = -2.6;
            const auto& last       = path->back();
            draw_path(diagram, *path, (-2.6 - last.origin.x) / last.direction.x, pen);
        }
    };
    for (double b = 0.04; b < 1; b += 0.04) draw(b, {Ink::blue, course::Weight::thin});
    draw(bundled, {Ink::vermilion, course::Weight::thick});
    // the angle between the sun's rays and what comes back
    const auto                 exit = on_paper(through_drop(bundled, n)->back().origin);
    const double               bow  = std::numbers::pi - deviation(*through_drop(bundled, n));
    std::vector<course::Point> arc;
    for (int i = 0; i <= 20; ++i)
        arc.push_back(exit + 2.0 * on_paper(heading(std::numbers::pi + bow * i / 20)));
    diagram.line(exit, exit + course::Point{-2.4, 0}, {Ink::grey, course::Weight::medium, true});
    diagram.line(arc, {Ink::vermilion});
    diagram.label({-2.7, exit.y - 0.3}, fmt::format("${:.1f}^\\circ$", degrees(bow)), course::Anchor::right,
                  Ink::vermilion);
    diagram.label({-2.6, 1.12}, "sunlight", course::Anchor::left, Ink::blue);
}

}  // namespace sr
