#pragma once
/// @file diagrams.hpp
/// The drawings of chapter 3.

#include <array>
#include <cmath>
#include <string>

#include "course/chapter.hpp"

namespace sr {

/// The point of a triangle with the weights b1 and b2, equation (3.1).
[[nodiscard]] inline course::Point weighted(const std::array<course::Point, 3>& p, double b1, double b2) {
    return (1 - b1 - b2) * p[0] + b1 * p[1] + b2 * p[2];
}

/// Figure 3.1: lines of equal weight, and the three areas that a point cuts the triangle into.
inline void draw_weights(course::Diagram diagram) {
    using course::Anchor, course::Ink, course::Weight;
    const std::array<course::Point, 3> p{{{0, 0}, {7, -0.6}, {2.2, 5}}};
    const auto                         inside = weighted(p, 0.25, 0.5);

    diagram.polygon({p[1], p[2], inside}, {Ink::grey, Weight::thin}, 0.10);
    diagram.polygon({p[2], p[0], inside}, {Ink::vermilion, Weight::thin}, 0.22);
    diagram.polygon({p[0], p[1], inside}, {Ink::blue, Weight::thin}, 0.22);
    for (const double b : {0.25, 0.5, 0.75}) {
        diagram.line(weighted(p, b, 0), weighted(p, b, 1 - b), {Ink::vermilion, Weight::thin, true});
        diagram.line(weighted(p, 0, b), weighted(p, 1 - b, b), {Ink::blue, Weight::thin, true});
        diagram.label(weighted(p, b, 0) + course::Point{0, -0.38},
                      b == 0.5  ? "1/2"
                      : b < 0.5 ? "$b_1 = 1/4$"
                                : "3/4",
                      Anchor::centre, Ink::vermilion);
        diagram.label(weighted(p, 0, b) + course::Point{-0.2, 0.1},
                      b == 0.5  ? "1/2"
                      : b < 0.5 ? "$b_2 = 1/4$"
                                : "3/4",
                      Anchor::right, Ink::blue);
    }
    diagram.polygon({p[0], p[1], p[2]}, {Ink::black, Weight::thick});
    diagram.point(inside, {Ink::black});
    const course::Point aside{5.6, 3.4};
    diagram.arrow(aside, inside + 0.06 * (aside - inside), {Ink::black, Weight::thin});
    diagram.label(aside + course::Point{0.12, 0.12}, "$\\mathbf{p}(1/4, 1/2)$");
    diagram.label(p[0] + course::Point{-0.2, -0.25}, "$\\mathbf{p}_0$", Anchor::right);
    diagram.label(p[1] + course::Point{0.2, -0.1}, "$\\mathbf{p}_1$");
    diagram.label(p[2] + course::Point{0.1, 0.3}, "$\\mathbf{p}_2$", Anchor::centre);
}

/// One panel of figure 3.2: two triangles with the edge from a to b, and the edge as each of them has it.
class EdgePanel {
public:
    EdgePanel(course::Diagram diagram, double left) : diagram_(std::move(diagram)), left_(left) {}

    /// The edge's ends as the left triangle has them are moved by `of_left`, as the right one has them by `of_right`.
    void triangles(course::Point of_left, course::Point of_right) {
        using course::Ink, course::Weight;
        const course::Point a = at(3, 0), b = at(3.4, 5);
        diagram_.polygon({a + of_left, b - of_left, at(0, 2.2)}, {Ink::blue}, 0.2);
        diagram_.polygon({a + of_right, b - of_right, at(6.4, 2.9)}, {Ink::green}, 0.2);
        diagram_.line(a, b, {Ink::grey, Weight::medium, true});
        diagram_.point(a, {Ink::black});
        diagram_.point(b, {Ink::black});
    }

    void ray(course::Point where, const std::string& says) {
        diagram_.point(at(where.x, where.y), {course::Ink::vermilion});
        diagram_.label(at(3.2, -1.5), says, course::Anchor::centre, course::Ink::vermilion);
    }

    void title(const std::string& text) { diagram_.label(at(3.2, 6.2), text, course::Anchor::centre); }

private:
    [[nodiscard]] course::Point at(double x, double y) const { return {left_ + x, y}; }

    course::Diagram diagram_;
    double          left_;
};

/// Figure 3.2: how a ray slips between two triangles, and why it can't if both see the same vertices.
inline void draw_slit(course::Diagram diagram) {
    EdgePanel alone(diagram, 0);
    alone.triangles({-0.4, 0}, {0.4, 0});
    alone.title("each triangle rounds the edge");
    alone.ray({3.13, 1.1}, "the ray is on neither");
    EdgePanel together(diagram, 9);
    together.triangles({0.4, 0.1}, {0.4, 0.1});
    together.title("the ray rounds the vertices");
    together.ray({3.13, 1.1}, "on one of the two");
    diagram.label({7.7, 5.4}, "the edge as it is", course::Anchor::centre);
    diagram.arrow({5.8, 5.4}, {3.62, 5.07}, {course::Ink::black, course::Weight::thin});
    diagram.arrow({9.6, 5.4}, {12.18, 5.07}, {course::Ink::black, course::Weight::thin});
}

}  // namespace sr
