#pragma once
/// @file method_diagrams.hpp
/// The drawings of section 2.4: three ways to look for a root, at work. All that they show is computed.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "course/chapter.hpp"
#include "geometry/implicit_ellipsoid.hpp"
#include "geometry/implicit_intervals.hpp"
#include "geometry/implicit_marching.hpp"
#include "geometry/implicit_sphere_tracing.hpp"
#include "geometry/implicit_torus.hpp"
#include "geometry/sphere.hpp"
#include "loose_bounds.hpp"

namespace sr {

/// A circle's outline on paper, from an angle [rad] on.
[[nodiscard]] inline std::vector<course::Point> circle(course::Point centre, double radius, double from = 0) {
    std::vector<course::Point> outline;
    for (int i = 0; i < 72; ++i) {
        const double angle = from + 2 * std::numbers::pi * i / 72;
        outline.push_back(centre + radius * course::Point{std::cos(angle), std::sin(angle)});
    }
    return outline;
}

/// Where a level ray is at t, seen from above.
[[nodiscard]] inline course::Point on_paper(const Ray<double>& ray, double t) {
    return {ray.at(t).x, ray.at(t).y};
}

/// The ring between two circles, as one outline: it is cut where the level ray leaves the ring, so that the ray hides
/// the cut.
[[nodiscard]] inline std::vector<course::Point> ring_cut_by(const Ray<double>& ray, double inner,
                                                            double outer) {
    const auto from = [&](double radius) {
        const auto leaves = crossings(Sphere<double>{{0, 0, 0}, radius}, ray);
        const auto p      = on_paper(ray, leaves ? leaves->second : 0);
        return circle({0, 0}, radius, std::atan2(p.y, p.x));
    };
    auto       wall = from(outer);
    const auto hole = from(inner);
    wall.push_back(wall.front());
    wall.push_back(hole.front());
    wall.insert(wall.end(), hole.rbegin(), hole.rend());
    return wall;
}

/// Fixed steps through a thin ring: they step over its near side, and find the far one.
inline void draw_marching(course::Diagram diagram) {
    using course::Ink;
    const LooseBounds<Torus<double>, double> ring{{1.5, 0.1}, 4};
    const Ray<double>                        ray{{-3.35, -0.431, 0}, {1, 0.1, 0}};
    constexpr double                         step = 0.4;

    diagram.polygon(ring_cut_by(ray, 1.4, 1.6), {Ink::grey, course::Weight::thin}, 0.3);
    diagram.line(on_paper(ray, 0), on_paper(ray, 6.3), {Ink::black, course::Weight::thin});
    const auto found = march(ring, ray, in_front<double>, step).value_or(0);
    const auto first = bisect_intervals(ring, ray, in_front<double>, 1e-9).value_or(0);
    for (int i = 0; i * step <= 6.3; ++i) {
        const bool inside = on_ray(ring, ray, i * step) < 0;
        diagram.point(on_paper(ray, i * step), {inside ? Ink::vermilion : Ink::blue});
    }
    for (const auto& [t, ink] : {std::pair{first, Ink::green}, {found, Ink::vermilion}})
        diagram.polygon(circle(on_paper(ray, t), 0.1), {ink, course::Weight::thick});
    diagram.label(on_paper(ray, first) + course::Point{-0.1, 0.45}, "first root, missed",
                  course::Anchor::right, Ink::green);
    diagram.label(on_paper(ray, found) + course::Point{0.25, 0.42}, "the root that is found",
                  course::Anchor::left, Ink::vermilion);
    diagram.label(on_paper(ray, 0.2) + course::Point{0, -0.3}, "step $s$", course::Anchor::centre, Ink::blue);
}

/// Spheres of radius |f| / L along a ray to the unit sphere, and the step that takes f itself for the distance.
inline void draw_sphere_tracing(course::Diagram diagram) {
    using course::Ink;
    const LooseBounds<Ellipsoid<double>, double> sphere{{{1, 1, 1}}, 6};
    const Ray<double>                            ray{{-5, 0.55, 0}, {1, 0, 0}};
    const double bound = lipschitz_bound(sphere, Box<double>{{-5, 0.55, 0}, {5, 0.55, 0}});

    diagram.polygon(circle({0, 0}, 1), {Ink::grey}, 0.3);
    diagram.line(on_paper(ray, 0), on_paper(ray, 7), {Ink::black, course::Weight::thin});
    for (double t = 0, radius = 1; radius > 0.004; t += radius) {
        radius = std::abs(on_ray(sphere, ray, t)) / bound;
        diagram.polygon(circle(on_paper(ray, t), radius), {Ink::blue}, 0.06);
        diagram.point(on_paper(ray, t), {Ink::blue});
    }
    const double root = sphere_trace(sphere, ray, in_front<double>, bound, 1e-9).value_or(0);
    diagram.point(on_paper(ray, root), {Ink::green});
    // The step is longer than the paper: its arrow is broken.
    diagram.line({-5, -1.6}, {0.4, -1.6}, {Ink::vermilion});
    diagram.arrow({0.6, -1.6}, {2.6, -1.6}, {Ink::vermilion});
    for (const double x : {0.4, 0.6}) diagram.line({x - 0.06, -1.75}, {x + 0.06, -1.45}, {Ink::vermilion});
    diagram.label({-1.2, -1.95},
                  fmt::format("$f$ taken for the distance: a step of {:.1f}", on_ray(sphere, ray, 0.0)),
                  course::Anchor::centre, Ink::vermilion);
    diagram.label({-5, 1.5}, "no root within $f/L$", course::Anchor::centre, Ink::blue);
    diagram.label({-0.45, 0.95}, "the hit", course::Anchor::right, Ink::green);
}

/// f along a ray through a torus, and the pieces of the ray of which interval arithmetic proves something, as boxes
/// from the least to the largest value that f may have there. Values on paper are compressed, large ones most.
class IntervalPicture {
public:
    explicit IntervalPicture(course::Diagram diagram) : diagram_(std::move(diagram)) {}

    void draw() {
        using course::Ink;
        std::vector<Interval<double>> waiting{{2, 8}};
        while (!waiting.empty()) {
            const auto piece = waiting.back();
            waiting.pop_back();
            const Proof  proof  = prove(torus_, ray_, piece);
            const double middle = (piece.min + piece.max) / 2;
            if (proof == Proof::nothing) {
                waiting.push_back({middle, piece.max});
                waiting.push_back({piece.min, middle});
            } else {
                const bool by_value = !on_ray(torus_, ray_, piece).contains(0);
                box(piece, by_value ? Ink::blue : proof == Proof::one_root ? Ink::green : Ink::amber);
            }
        }
        diagram_.line(at(1.9, 0), at(8.1, 0), {Ink::black, course::Weight::thin});
        curve();
        diagram_.label(at(8.2, 0), "$t$");
        diagram_.label(at(5, 120), "no value is 0: no root", course::Anchor::centre, Ink::blue);
        diagram_.label(at(5, -35), "no slope is 0, signs differ: one root", course::Anchor::centre,
                       Ink::green);
        diagram_.label(at(5, -75), "no slope is 0, signs agree: no root", course::Anchor::centre, Ink::amber);
    }

private:
    [[nodiscard]] static course::Point at(double t, double value) { return {t, 0.4 * std::asinh(value / 3)}; }

    void box(Interval<double> piece, course::Ink ink) {
        const auto f = on_ray(torus_, ray_, piece);
        diagram_.polygon(
            {at(piece.min, f.min), at(piece.max, f.min), at(piece.max, f.max), at(piece.min, f.max)},
            {ink, course::Weight::thin}, 0.25);
    }

    void curve() {
        std::vector<course::Point> points;
        for (int i = 0; i <= 300; ++i) points.push_back(at(2 + 0.02 * i, on_ray(torus_, ray_, 2 + 0.02 * i)));
        diagram_.line(points, {course::Ink::black, course::Weight::thick});
    }

    course::Diagram diagram_;
    Torus<double>   torus_{2, 0.5};
    Ray<double>     ray_{{-5, 0.8, 0.1}, {1, 0, 0}};
};

}  // namespace sr
