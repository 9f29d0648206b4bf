#pragma once
/// @file hierarchy.hpp
/// A binary hierarchy of boxes over a mesh's triangles, and how a ray walks it.
///
///     const Hierarchy<float> hierarchy(mesh);
///     if (const auto hit = hierarchy.nearest(ray)) shade(hit->face, hit->t);
///     if (hierarchy.occluded(ray, {0, distance})) ...

#include <array>
#include <concepts>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "geometry/hierarchy_build.hpp"
#include "geometry/hierarchy_node.hpp"
#include "geometry/nearest.hpp"

namespace sr {

template <std::floating_point T>
class Hierarchy {
public:
    explicit Hierarchy(const Mesh<T>& mesh) {
        const auto          unordered = face_triangles(mesh);
        HierarchyBuilder<T> builder(unordered);
        triangles_.reserve(unordered.size());
        for (const std::uint32_t i : builder.order()) triangles_.push_back(unordered[i]);
        nodes_ = std::move(builder).nodes();
    }

    /// The hit with the least t in `range`, the same to the bit as BruteForce's.
    /// @pre range.min >= 0; a ray that is not finite hits nothing
    [[nodiscard]] std::optional<MeshHit<T>> nearest(const Ray<T>& ray,
                                                    Interval<T>   range = in_front<T>) const {
        NearestSearch<T> search(ray, range);
        walk(search, [] { return false; });
        return search.result();
    }

    /// Whether anything is hit in `range`; stops at the first leaf with a hit.
    /// @pre range.min >= 0
    [[nodiscard]] bool occluded(const Ray<T>& ray, Interval<T> range = in_front<T>) const {
        NearestSearch<T> search(ray, range);
        walk(search, [&] { return search.result().has_value(); });
        return search.result().has_value();
    }

private:
    using Child = typename HierarchyNode<T>::Child;

    /// A child that has to wait for its nearer sibling, and where the ray enters it.
    struct Waiting {
        Child child;
        T     near;
    };

    /// Offers the triangles of the leaves that the ray passes through, nearer child first, until `enough`. A
    /// box is left out only where it begins beyond the nearest hit: at equal t another face may still win.
    template <class Enough>
    void walk(NearestSearch<T>& search, Enough enough) const {
        if (triangles_.empty()) return;
        std::array<Waiting, HierarchyBuilder<T>::max_depth> stack;
        std::size_t                                         waiting = 0;

        const BoxRay<T> boxes = search.boxes();
        Interval<T>     range = search.range();
        Child           here{0, 0};
        for (;;) {
            if (here.count == 0) {
                const HierarchyNode<T>& node    = nodes_[here.first];
                const Interval<T>       left    = boxes.clip(node.box[0], range);
                const Interval<T>       right   = boxes.clip(node.box[1], range);
                const bool              in_left = !left.empty(), in_right = !right.empty();
                if (in_left && in_right) {
                    const bool left_first = left.min <= right.min;
                    stack[waiting++] =
                        left_first ? Waiting{node.child[1], right.min} : Waiting{node.child[0], left.min};
                    here = node.child[left_first ? 0 : 1];
                    continue;
                }
                if (in_left || in_right) {
                    here = node.child[in_left ? 0 : 1];
                    continue;
                }
            } else {
                for (std::uint32_t i = 0; i < here.count; ++i) search.offer(triangles_[here.first + i]);
                if (enough()) return;
                range = search.range();
            }
            do {
                if (waiting == 0) return;
                --waiting;
            } while (stack[waiting].near > range.max);
            here = stack[waiting].child;
        }
    }

    std::vector<HierarchyNode<T>> nodes_;
    std::vector<FaceTriangle<T>>  triangles_;  ///< in the order of the leaves
};

}  // namespace sr
