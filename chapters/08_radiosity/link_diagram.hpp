#pragma once
/// @file link_diagram.hpp
/// Which patches of a floor and a wall exchange light, and at which size.

#include <fmt/format.h>

#include <vector>

#include "course/chapter.hpp"
#include "radiosity/hierarchical_radiosity.hpp"

namespace sr {

/// A floor and a wall that meet, both of side 1, the floor bright.
inline HierarchicalSolution linked_corner(double bound) {
    const std::vector<Polygon> polygons{
        {Patch{{0, 0, 0}, {0, 1, 0}, {1, 1, 0}, {1, 0, 0}}.reversed(), {0.5, 0.5, 0.5}, {1, 1, 1}, 0},
        {Patch{{0, 0, 0}, {0, 1, 0}, {0, 1, 1}, {0, 0, 1}}, {0.5, 0.5, 0.5}, {1, 1, 1}, 0}};
    const Visibility visibility{mesh_of(cut(polygons, 1)).mesh};
    return hierarchical_radiosity(polygons, visibility, {.bound = bound, .oracle = LinkOracle::power});
}

/// How often its polygon was quartered to make each node.
inline std::vector<int> levels(const Quadtrees& trees) {
    std::vector<int> level(trees.size());
    for (std::size_t i = 0; i < trees.size(); ++i)
        for (std::size_t k = 0; k < (trees[i].is_leaf() ? 0 : 4); ++k)
            level[trees[i].first_child + k] = level[i] + 1;
    return level;
}

/// The links of one level of receivers, and the nodes that they join, in an oblique view.
inline void draw_links(course::Diagram diagram, const HierarchicalSolution& solution, int of_level,
                       course::Point origin) {
    using course::Point;
    const auto& trees = solution.trees;
    const auto  level = levels(trees);
    const auto  place = [&](const Vector3<double>& p) {  // y goes away from the eye
        return origin + 4.0 * Point{p.x + 0.5 * p.y, p.z + 0.32 * p.y};
    };
    const auto outline = [&](const Patch& patch, course::Pen pen, double opacity) {
        std::vector<Point> corners;
        for (const auto& p : patch.corners()) corners.push_back(place(p));
        diagram.polygon(corners, pen, opacity);
    };
    for (std::size_t i = 0; i < trees.size(); ++i)
        if (level[i] == of_level) outline(trees[i].shape, {course::Ink::grey, course::Weight::thin}, 0.08);
    for (std::size_t i = 0; i < 2; ++i) outline(trees[i].shape, {course::Ink::black}, 0);
    for (const auto& link : solution.links)
        if (level[link.receiver] == of_level && trees[link.receiver].polygon == 1)
            diagram.line(place(trees[link.receiver].shape.centre()), place(trees[link.source].shape.centre()),
                         {course::Ink::blue, course::Weight::thin});
}

/// Figure 8.32: the wall's links, level by level.
inline void draw_link_levels(course::Diagram diagram) {
    const auto solution = linked_corner(2e-3);
    for (int level = 1; level <= 3; ++level) {
        const double x = 7.4 * (level - 1);
        draw_links(diagram, solution, level, {x, 0});
        diagram.label({x + 3, -0.8},
                      fmt::format("cut {}", level == 1   ? "once"
                                            : level == 2 ? "twice"
                                                         : "three times"),
                      course::Anchor::centre);
    }
}

}  // namespace sr
