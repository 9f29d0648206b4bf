#pragma once
/// @file box_diagram.hpp
/// Figure 4.4: what lies some cuts below the root, by halves (median) and by cost (swept).

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "course/chapter.hpp"
#include "scene/teapot.hpp"
#include "work.hpp"

namespace sr {

/// The boxes at a depth below a child, and the leaves above that depth.
inline void collect_boxes(const HierarchyTree<float>& tree, HierarchyNode<float>::Child child,
                          const Box<float>& box, int depth, std::vector<Box<float>>& boxes) {
    if (depth == 0 || child.is_leaf()) {
        boxes.push_back(box);
        return;
    }
    const auto& node = tree.nodes[child.first];
    for (std::size_t side = 0; side < 2; ++side)
        collect_boxes(tree, node.child[side], node.box[side], depth - 1, boxes);
}

/// Which vertices are joined to which.
using Edges = std::map<std::uint32_t, std::set<std::uint32_t>>;

/// The edges of a mesh in the plane y = 0.
[[nodiscard]] inline Edges edges_in_the_middle(const Mesh<double>& mesh) {
    const auto inside = [&](std::uint32_t vertex) { return std::abs(mesh.vertices[vertex].y) < 1e-9; };
    Edges      edges;
    for (const auto& face : mesh.faces) {
        for (std::size_t i = 0; i < 3; ++i) {
            const auto a = face[i], b = face[(i + 1) % 3];
            if (!inside(a) || !inside(b)) continue;
            edges[a].insert(b);
            edges[b].insert(a);
        }
    }
    return edges;
}

/// Goes along edges that nobody went along before, until there is none. @return the vertices on the way
[[nodiscard]] inline std::vector<std::uint32_t> walk_edges(Edges& edges, std::uint32_t from) {
    std::vector<std::uint32_t> way{from};
    while (!edges[from].empty()) {
        const auto to = *edges[from].begin();
        edges[from].erase(to);
        edges[to].erase(from);
        way.push_back(from = to);
    }
    return way;
}

/// The teapot's outline from the side: its mesh is symmetric in the plane y = 0.
inline void draw_outline(course::Diagram diagram, double left) {
    const auto mesh  = teapot(4);
    auto       edges = edges_in_the_middle(mesh);
    const auto draw  = [&](std::uint32_t from) {
        std::vector<course::Point> line;
        for (const auto vertex : walk_edges(edges, from))
            line.emplace_back(left + mesh.vertices[vertex].x, mesh.vertices[vertex].z);
        if (line.size() > 1) diagram.line(line, {course::Ink::grey});
    };
    const Edges all = edges;
    for (const auto& [vertex, neighbours] : all)
        if (neighbours.size() % 2 == 1) draw(vertex);  // the ends first, for long lines
    for (const auto& [vertex, neighbours] : all) draw(vertex);
}

/// The mesh's boxes at a depth, seen along the y axis.
inline void draw_boxes(course::Diagram diagram, const Mesh<float>& mesh, Cut cut, int depth, double left,
                       course::Ink ink, const std::string& title) {
    const auto              hierarchy = boxes_of(mesh, cut);
    const auto&             tree      = hierarchy.tree();
    std::vector<Box<float>> boxes;
    collect_boxes(tree, tree.root, tree.box, depth, boxes);
    const auto at = [&](float x, float z) { return course::Point{left + double(x), double(z)}; };
    for (const auto& [min, max] : boxes)
        diagram.polygon({at(min.x, min.z), at(max.x, min.z), at(max.x, max.z), at(min.x, max.z)},
                        {ink, course::Weight::thin}, 0.06);
    diagram.label(at(tree.box.centre().x, tree.box.max.z + 0.35F), title, course::Anchor::centre, ink);
}

inline void draw_boxes(const course::Diagram& diagram, const Mesh<float>& mesh) {
    draw_outline(diagram, 0);
    draw_outline(diagram, 7.2);
    draw_boxes(diagram, mesh, Cut::median, 6, 0, course::Ink::blue, "median");
    draw_boxes(diagram, mesh, Cut::swept, 6, 7.2, course::Ink::green, "swept");
}

}  // namespace sr
