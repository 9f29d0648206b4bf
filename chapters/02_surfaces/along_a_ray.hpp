#pragma once
/// @file along_a_ray.hpp
/// Figure 2.1: a surface cut by a line, and its function along that line. Everything in it is computed.

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "course/chapter.hpp"
#include "math/bracketed_root.hpp"
#include "math/vector.hpp"

namespace sr {

/// Three blobs of a plane and a line through them: f < 0 inside.
struct BlobScene {
    struct Blob {
        Vector2<double> centre;
        double          radius;
    };
    std::vector<Blob> blobs{{{1.3, 3.05}, 1.15}, {{6.4, 2.6}, 1.3}, {{10.3, 3.55}, 1.45}};
    Vector2<double>   origin{3.6, 3.0};
    double            begin = -0.4, end = 13;  ///< of the line, in x

    [[nodiscard]] double f(Vector2<double> p) const {
        double sum = 0;
        for (const auto& blob : blobs) {
            const auto s = (p - blob.centre) / blob.radius;
            sum += std::exp(1 - dot(s, s));
        }
        return 1 - sum;
    }
    [[nodiscard]] double along(double x) const { return f({x, origin.y}); }
};

/// The x at which the line meets the surface, behind the origin and before it.
[[nodiscard]] inline std::vector<double> hits(const BlobScene& scene) {
    const auto          f    = [&](double x) { return scene.along(x); };
    const double        step = 0.05;
    std::vector<double> result;
    for (double x = scene.begin; x < scene.end; x += step) {
        if ((f(x) < 0) != (f(x + step) < 0))
            result.push_back(bisect(f, Interval<double>{x, x + step}).value());
    }
    return result;
}

inline void draw_blobs(course::Diagram diagram, const BlobScene& scene) {
    for (const auto& [centre, radius] : scene.blobs) {
        std::vector<course::Point> outline;
        for (int i = 0; i < 120; ++i) {
            const double angle = i * std::numbers::pi / 60;
            const auto   at    = [&, c = centre](double r) {
                return c + r * Vector2<double>{std::cos(angle), std::sin(angle)};
            };
            const auto f = [&](double r) { return scene.f(at(r)); };
            const auto p = at(bisect(f, Interval<double>{0, 1.7 * radius}).value());
            outline.emplace_back(p.x, p.y);
        }
        diagram.polygon(outline, {course::Ink::green}, 0.25);
        diagram.label({centre.x, centre.y + (centre.y > scene.origin.y ? 0.5 : -0.5)}, "$f < 0$",
                      course::Anchor::centre, course::Ink::green);
    }
    diagram.label({3.75, 4.4}, "$f > 0$", course::Anchor::centre, course::Ink::grey);
}

/// The graph of f below the plane, on the same x.
inline void draw_graph(course::Diagram diagram, const BlobScene& scene) {
    using course::Ink;
    constexpr double zero = -1.1, height = 0.9;
    diagram.arrow({scene.begin, zero}, {scene.end + 0.4, zero}, {Ink::grey, course::Weight::thin});
    diagram.label({scene.end + 0.55, zero}, "$t$");
    std::vector<course::Point> graph;
    for (double x = scene.begin; x <= scene.end; x += 0.05)
        graph.emplace_back(x, zero + height * scene.along(x));
    diagram.line(graph, {Ink::blue, course::Weight::thick});
    diagram.label({11.75, zero - 0.6}, "$f(\\mathbf{o} + t\\,\\mathbf{d})$", course::Anchor::left, Ink::blue);
    const double o = scene.origin.x;
    diagram.line({o, scene.origin.y}, {o, zero}, {Ink::grey, course::Weight::thin, true});
    diagram.label({o, zero - 0.4}, "$t = 0$", course::Anchor::centre);
}

/// The surface, the ray, f along it, and which of the zeros counts.
inline void draw_along_a_ray(course::Diagram diagram) {
    using course::Ink;
    constexpr double zero = -1.1;
    const BlobScene  scene;
    const double     y = scene.origin.y;
    draw_blobs(diagram, scene);
    draw_graph(diagram, scene);
    diagram.line({scene.begin, y}, {scene.origin.x, y}, {Ink::grey, course::Weight::medium, true});
    diagram.arrow({scene.origin.x, y}, {scene.end + 0.4, y}, {Ink::vermilion, course::Weight::thick});
    bool found = false;
    for (const double x : hits(scene)) {
        const bool nearest = !found && x > scene.origin.x;
        found              = found || nearest;
        const Ink ink      = nearest ? Ink::vermilion : Ink::grey;
        diagram.line({x, y}, {x, zero}, {ink, course::Weight::thin, true});
        diagram.point({x, y}, {ink});
        diagram.point({x, zero}, {ink});
        if (nearest)
            diagram.label({x + 0.2, zero + 0.4}, "nearest $t$", course::Anchor::left, Ink::vermilion);
    }
    diagram.point({scene.origin.x, y});
    diagram.label({scene.origin.x, y + 0.4}, "$\\mathbf{o}$", course::Anchor::centre);
}

}  // namespace sr
