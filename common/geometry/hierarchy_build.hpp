#pragma once
/// @file hierarchy_build.hpp
/// Builds a binary hierarchy: triangles are cut in two, again and again, in one of three ways.

#include <array>
#include <concepts>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "geometry/cut_binned.hpp"
#include "geometry/cut_median.hpp"
#include "geometry/cut_swept.hpp"
#include "geometry/hierarchy_node.hpp"
#include "geometry/nearest.hpp"

namespace sr {

/// Where to cut: into equal halves; or by the surface-area heuristic, tried at bins or between all centres.
enum class Cut { median, binned, swept };

/// Writes nodes depth first.
/// @param Cutter  MedianCut<T>, BinnedCut<T> or SweptCut<T>
template <std::floating_point T, class Cutter>
class HierarchyBuilder {
public:
    explicit HierarchyBuilder(std::vector<BoxReference<T>> references) : cutter_(std::move(references)) {}

    /// @pre there is a triangle
    [[nodiscard]] HierarchyTree<T> tree(std::span<const FaceTriangle<T>> triangles) && {
        const BoxSet<T> all = cutter_.set(0, cutter_.size());
        tree_.box           = all.box;
        tree_.root          = build(all, 0);
        tree_.triangles.reserve(triangles.size());
        for (std::uint32_t i = 0; i < cutter_.size(); ++i)
            tree_.triangles.push_back(triangles[cutter_.triangle(i)]);
        return std::move(tree_);
    }

private:
    using Child = typename HierarchyNode<T>::Child;

    /// Cuts by cost may take off one triangle at a time: beyond half of the depth, sets are halved.
    static constexpr std::size_t halved_depth = HierarchyTree<T>::max_depth / 2;

    Child build(const BoxSet<T>& set, std::size_t depth) {
        const Child leaf{set.begin, set.count()};
        if (set.count() <= 1) return leaf;
        if (depth >= halved_depth)
            return set.count() <= largest_leaf ? leaf : node(set, cutter_.halve(set), depth);
        const auto middle = cutter_.cut(set);
        return middle ? node(set, *middle, depth) : leaf;
    }

    Child node(const BoxSet<T>& set, std::uint32_t middle, std::size_t depth) {
        const auto index = std::uint32_t(tree_.nodes.size());
        tree_.nodes.emplace_back();
        const std::array half{cutter_.set(set.begin, middle), cutter_.set(middle, set.end)};
        for (std::size_t side = 0; side < 2; ++side) {
            const Child child              = build(half[side], depth + 1);  // moves the nodes
            tree_.nodes[index].box[side]   = half[side].box;
            tree_.nodes[index].child[side] = child;
        }
        return {index, 0};
    }

    Cutter           cutter_;
    HierarchyTree<T> tree_;
};

/// The hierarchy of some triangles, none of them left out.
template <std::floating_point T>
[[nodiscard]] HierarchyTree<T> build_hierarchy(const std::vector<FaceTriangle<T>>& triangles, Cut cut) {
    if (triangles.empty()) return {};
    std::vector<BoxReference<T>> references;
    references.reserve(triangles.size());
    for (std::uint32_t i = 0; i < triangles.size(); ++i)
        references.emplace_back(bounds(triangles[i].triangle), i);
    switch (cut) {
        case Cut::median:
            return HierarchyBuilder<T, MedianCut<T>>(std::move(references)).tree(triangles);
        case Cut::swept:
            return HierarchyBuilder<T, SweptCut<T>>(std::move(references)).tree(triangles);
        case Cut::binned:
            break;
    }
    return HierarchyBuilder<T, BinnedCut<T>>(std::move(references)).tree(triangles);
}

}  // namespace sr
