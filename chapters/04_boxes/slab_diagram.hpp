#pragma once
/// @file slab_diagram.hpp
/// Figure 4.1: slabs in the plane, and the intervals of t in which a ray is between their planes.

#include <algorithm>
#include <string>
#include <utility>

#include "course/chapter.hpp"
#include "math/interval.hpp"

namespace sr {

/// One panel: a ray, the two slabs of a box, and below them the axis of t.
class SlabPanel {
public:
    using Point = course::Point;

    SlabPanel(course::Diagram diagram, double left, Point direction)
        : diagram_(std::move(diagram)), left_(left), direction_(direction) {}

    void draw(const std::string& title, double ray_end) {
        draw_slabs();
        draw_ray(ray_end);
        draw_intervals();
        diagram_.label(at({width / 2, height + 0.45}), title, course::Anchor::centre);
    }

private:
    static constexpr double width = 7, height = 5.6, time_axis = -3.1;
    static constexpr Point  low{3.4, 1.5}, high{5.4, 3.1};  // the box
    static constexpr Point  origin{0.3, 0.3};

    static constexpr course::Ink x_ink = course::Ink::blue, y_ink = course::Ink::green,
                                 box_ink = course::Ink::vermilion;

    [[nodiscard]] Point at(Point p) const { return {left_ + p.x, p.y}; }
    [[nodiscard]] Point on_ray(double t) const { return at(origin + t * direction_); }
    /// On the axis of t or above it: straight below the ray's point.
    [[nodiscard]] Point below_ray(double t, double y) const { return {on_ray(t).x, y}; }

    /// (4.1) of the planes of one slab.
    [[nodiscard]] Interval<double> between(double Point::*axis) const {
        return {(low.*axis - origin.*axis) / (direction_.*axis),
                (high.*axis - origin.*axis) / (direction_.*axis)};
    }

    void area(Point from, Point to, course::Ink ink, double opacity) {
        diagram_.polygon({at(from), at({to.x, from.y}), at(to), at({from.x, to.y})},
                         {ink, course::Weight::thin}, opacity);
    }

    void draw_slabs() {
        area({low.x, 0}, {high.x, height}, x_ink, 0.12);
        area({0, low.y}, {width, high.y}, y_ink, 0.12);
        diagram_.polygon({at(low), at({high.x, low.y}), at(high), at({low.x, high.y})},
                         {course::Ink::black, course::Weight::thick});
        diagram_.label(at({high.x + 0.15, 0.3}), "$x$ slab", course::Anchor::left, x_ink);
        diagram_.label(at({width + 0.15, (low.y + high.y) / 2}), "$y$ slab", course::Anchor::left, y_ink);
    }

    void draw_ray(double end) {
        diagram_.arrow(on_ray(0), on_ray(end), {course::Ink::black});
        diagram_.point(on_ray(0));
        diagram_.label(on_ray(0) + Point{0.1, -0.3}, "$\\mathbf{o}$");
        for (const auto& [interval, ink] :
             {std::pair{between(&Point::x), x_ink}, {between(&Point::y), y_ink}}) {
            for (const double t : {interval.min, interval.max})
                if (t <= end) diagram_.point(on_ray(t), {ink});
        }
    }

    void bar(Interval<double> interval, double y, course::Ink ink, const std::string& name) {
        const double from = on_ray(interval.min).x, to = std::min(on_ray(interval.max).x, left_ + width);
        diagram_.polygon({{from, y - 0.13}, {to, y - 0.13}, {to, y + 0.13}, {from, y + 0.13}},
                         {ink, course::Weight::thin}, 0.6);
        diagram_.label(at({-0.15, y}), name, course::Anchor::right, ink);
    }

    void draw_intervals() {
        const auto             x = between(&Point::x), y = between(&Point::y);
        const Interval<double> both{std::max(x.min, y.min), std::min(x.max, y.max)};
        diagram_.arrow(at({0, time_axis}), at({width + 0.3, time_axis}));
        diagram_.label(at({width + 0.4, time_axis}), "$t$");
        diagram_.line(below_ray(0, time_axis - 0.12), below_ray(0, time_axis + 0.12));
        diagram_.label(below_ray(0, time_axis - 0.4), "0", course::Anchor::centre);
        bar(x, time_axis + 2.3, x_ink, "$x$");
        bar(y, time_axis + 1.6, y_ink, "$y$");
        for (const double t : {both.min, both.max})
            diagram_.line(below_ray(t, time_axis), on_ray(t),
                          {course::Ink::grey, course::Weight::thin, true});
        if (!both.empty()) bar(both, time_axis + 0.7, box_ink, "box");
        const bool hit = !both.empty();
        diagram_.label(below_ray(hit ? both.min : both.max, time_axis - 0.4),
                       hit ? "last entry" : "first exit", course::Anchor::right);
        diagram_.label(below_ray(hit ? both.max : both.min, time_axis - 0.4),
                       hit ? "first exit" : "last entry");
    }

    course::Diagram diagram_;
    double          left_;
    Point           direction_;
};

/// A ray that meets the box, and one that passes it.
inline void draw_slabs(const course::Diagram& diagram) {
    SlabPanel(diagram, 0, {1, 0.62}).draw("the intervals overlap: a hit", 6.2);
    SlabPanel(diagram, 10, {0.9, 1.0}).draw("they do not: a miss", 5.2);
}

}  // namespace sr
