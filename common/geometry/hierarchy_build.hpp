#pragma once
/// @file hierarchy_build.hpp
/// Builds a binary hierarchy by the surface-area heuristic: where to cut a set of triangles in two so that a
/// random ray is expected to do least work.

#include <algorithm>
#include <array>
#include <concepts>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "geometry/hierarchy_node.hpp"
#include "geometry/nearest.hpp"

namespace sr {

/// Cuts triangles in two, again and again, and writes nodes depth first.
/// @see Wald, On fast Construction of SAH-based Bounding Volume Hierarchies, 2007: bins instead of a sort
template <std::floating_point T>
class HierarchyBuilder {
public:
    /// No leaf lies deeper. Cuts by cost are unbounded in theory; beyond half of this, sets are halved.
    static constexpr std::size_t max_depth = 96;

    explicit HierarchyBuilder(std::span<const FaceTriangle<T>> triangles) {
        references_.reserve(triangles.size());
        for (std::uint32_t i = 0; i < triangles.size(); ++i) {
            references_.push_back({bounds(triangles[i].triangle), i});
        }
        Set all = measured(0, std::uint32_t(triangles.size()));
        // The root's second child is an empty box around the first triangle. Finite rays never enter it; one
        // that is not a number enters every box, and must come to an end all the same.
        nodes_.emplace_back();
        nodes_[0].box[0]   = all.box;
        const Child child  = build(all, 1);
        nodes_[0].child[0] = child;
        nodes_[0].child[1] = {0, 1};
    }

    [[nodiscard]] std::vector<HierarchyNode<T>> nodes() && { return std::move(nodes_); }

    /// The order in which leaves expect the triangles.
    [[nodiscard]] std::vector<std::uint32_t> order() const {
        std::vector<std::uint32_t> result;
        result.reserve(references_.size());
        for (const auto& reference : references_) result.push_back(reference.triangle);
        return result;
    }

private:
    using Child = typename HierarchyNode<T>::Child;

    /// What the builder moves about in a triangle's place.
    struct Reference {
        Box<T>        box;
        std::uint32_t triangle;
    };
    /// A range of references, the box around them and the box around their boxes' centres.
    struct Set {
        std::uint32_t begin, end;
        Box<T>        box, centres;
        std::uint32_t count() const { return end - begin; }
    };
    struct Cut {
        int axis;
        int bin;  ///< the first bin on the far side
        T   cost;
    };

    static constexpr int           bin_count    = 16;
    static constexpr std::uint32_t largest_leaf = 8;
    // In units of a triangle's test. Between 0.5 and 2 it hardly matters: see `course bench rays`.
    static constexpr T             step_cost = T(1.0);

    Set measured(std::uint32_t begin, std::uint32_t end) const {
        Set set{begin, end, {}, {}};
        for (std::uint32_t i = begin; i < end; ++i) {
            set.box.include(references_[i].box);
            set.centres.include(references_[i].box.centre());
        }
        return set;
    }

    Child build(const Set& set, std::size_t depth) {
        if (set.count() <= 1) return {set.begin, set.count()};
        const auto cut       = depth < max_depth / 2 ? cheapest_cut(set) : std::nullopt;
        const T    leaf_cost = T(set.count()) * set.box.half_area();
        const bool worth_it  = cut && cut->cost < leaf_cost;
        if (set.count() <= largest_leaf && !worth_it) return {set.begin, set.count()};
        const std::uint32_t middle = cut ? partition(set, *cut) : set.begin + set.count() / 2;

        const auto index = std::uint32_t(nodes_.size());
        nodes_.emplace_back();
        const std::array<Set, 2> half = {measured(set.begin, middle), measured(middle, set.end)};
        for (std::size_t side = 0; side < 2; ++side) {
            const Child child         = build(half[side], depth + 1);  // moves nodes_
            nodes_[index].box[side]   = half[side].box;
            nodes_[index].child[side] = child;
        }
        return {index, 0};
    }

    static int bin_of(const Set& set, const Reference& reference, int axis) {
        const T position = (reference.box.centre()[axis] - set.centres.min[axis]) / set.centres.size()[axis];
        return std::min(bin_count - 1, int(position * bin_count));
    }

    /// Expected work of a cut: a step, and for each half its triangles times the chance to enter it, which is
    /// the ratio of the surfaces; all multiplied by the surface of the whole.
    std::optional<Cut> cheapest_cut(const Set& set) const {
        std::optional<Cut> best;
        for (int axis = 0; axis < 3; ++axis) {
            if (!(set.centres.size()[axis] > 0)) continue;
            const auto cut = cheapest_cut(set, axis);
            if (cut && !(best && best->cost <= cut->cost)) best = cut;
        }
        return best;
    }

    std::optional<Cut> cheapest_cut(const Set& set, int axis) const {
        std::array<Box<T>, bin_count>        box;
        std::array<std::uint32_t, bin_count> count{};
        for (std::uint32_t i = set.begin; i < set.end; ++i) {
            const auto bin = std::size_t(bin_of(set, references_[i], axis));
            box[bin].include(references_[i].box);
            ++count[bin];
        }

        // Once from the near side, to keep the cost of what has been passed, and once from the far side.
        std::array<T, bin_count> near_cost{};
        Box<T>                   passed_box;
        std::uint32_t            passed = 0;
        for (std::size_t bin = 1; bin < bin_count; ++bin) {
            passed_box.include(box[bin - 1]);
            passed += count[bin - 1];
            near_cost[bin] = T(passed) * passed_box.half_area();
        }
        std::optional<Cut> best;
        passed_box = {};
        passed     = 0;
        for (std::size_t bin = bin_count - 1; bin > 0; --bin) {
            passed_box.include(box[bin]);
            passed += count[bin];
            if (passed == 0 || passed == set.count()) continue;
            const T cost =
                step_cost * set.box.half_area() + near_cost[bin] + T(passed) * passed_box.half_area();
            if (!(best && best->cost <= cost)) best = Cut{axis, int(bin), cost};
        }
        return best;
    }

    std::uint32_t partition(const Set& set, const Cut& cut) {
        const auto begin  = references_.begin() + set.begin;
        const auto middle = std::partition(begin, references_.begin() + set.end, [&](const Reference& r) {
            return bin_of(set, r, cut.axis) < cut.bin;
        });
        return set.begin + std::uint32_t(middle - begin);
    }

    std::vector<Reference>        references_;
    std::vector<HierarchyNode<T>> nodes_;
};

}  // namespace sr
