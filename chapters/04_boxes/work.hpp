#pragma once
/// @file work.hpp
/// How much a ray asks of a hierarchy, counted and predicted.

#include <array>
#include <string>

#include "geometry/hierarchy.hpp"
#include "image/image.hpp"
#include "isotropic_lines.hpp"
#include "statistics/running.hpp"

namespace sr {

/// A rung of the ladder.
struct Rung {
    std::string name;
    Cut         cut;
};
inline const std::array<Rung, 3> rungs{
    Rung{"median", Cut::median}, {"binned", Cut::binned}, {"swept", Cut::swept}};

/// Boxes down to the last: what the core leaves out for a few triangles is to be seen here.
[[nodiscard]] inline Hierarchy<float> boxes_of(const Mesh<float>& mesh, Cut cut) {
    return Hierarchy<float>(mesh, {.cut = cut, .asked_straight = 0});
}

/// Nodes and triangles that rays asked.
struct Work {
    Running nodes, triangles;

    void add(const WalkCount& count) {
        nodes.add(double(count.nodes));
        triangles.add(double(count.triangles));
    }
    void merge(const Work& other) {
        nodes.merge(other.nodes);
        triangles.merge(other.triangles);
    }
};

/// Wants no triangle, and is never content: walks all along the line.
class WholeLine {
public:
    explicit WholeLine(const Ray<float>& ray) : boxes_(ray) {}
    void                                 offer(const FaceTriangle<float>&) {}
    [[nodiscard]] const BoxRay<float>&   boxes() const { return boxes_; }
    [[nodiscard]] static Interval<float> range() { return in_front<float>; }

private:
    BoxRay<float> boxes_;
};

[[nodiscard]] inline Sphere<double> ball_around(const Box<float>& box) {
    return {Vector3<double>(box.centre()), double(length(box.size())) / 2};
}

[[nodiscard]] inline Ray<float> to_float(const Ray<double>& ray) {
    return {Vec3(ray.origin), Vec3(ray.direction)};
}

/// Lines that meet the root's box: as far as their nearest hit, or all along.
struct WorkOfLines {
    Work nearest, whole;

    void merge(const WorkOfLines& other) {
        nearest.merge(other.nearest);
        whole.merge(other.whole);
    }
};
[[nodiscard]] inline WorkOfLines work_of_lines(const Hierarchy<float>& hierarchy, const Draw& draw) {
    const auto& tree = hierarchy.tree();
    return over_lines<WorkOfLines>(ball_around(tree.box), draw,
                                   [&](WorkOfLines& work, const Ray<double>& line) {
                                       const Ray<float> ray = to_float(line);
                                       if (BoxRay<float>(ray).clip(tree.box, in_front<float>).empty()) return;
                                       WholeLine search(ray);
                                       WalkCount whole, nearest;
                                       walk(tree, search, whole);
                                       (void)hierarchy.nearest(ray, in_front<float>, nearest);
                                       work.whole.add(whole);
                                       work.nearest.add(nearest);
                                   });
}

/// Of the rays that meet the root's box: the others ask nothing.
[[nodiscard]] inline Work work_of_pixels(const Image<WalkCount>& counts) {
    Work work;
    for (const auto& count : counts.pixels())
        if (count.nodes > 0) work.add(count);
    return work;
}

}  // namespace sr
