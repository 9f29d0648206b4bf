#pragma once
/// @file box_diagram.hpp
/// Figure 4.4: what lies some cuts below the root, by halves and by cost.

#include <string>
#include <vector>

#include "course/chapter.hpp"
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
    draw_boxes(diagram, mesh, Cut::median, 6, 0, course::Ink::blue, "halves");
    draw_boxes(diagram, mesh, Cut::swept, 6, 7.2, course::Ink::vermilion, "least cost");
}

}  // namespace sr
