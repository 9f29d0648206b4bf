#pragma once
/// @file mistaken_hierarchy.hpp
/// What one can get wrong in a hierarchy, to see that a test would notice.

#include <cmath>
#include <cstdint>
#include <optional>

#include "geometry/hierarchy_build.hpp"
#include "geometry/nearest.hpp"

namespace sr {

enum class Mistake {
    none,
    strict_pruning,  ///< a box that begins at the nearest hit is left out, though a tie may be in it
    thin_boxes,      ///< boxes are not lengthened against rounding
    higher_face      ///< of equal t the higher face wins
};

/// Hierarchy's nodes, walked by plain recursion with a mistake.
class MistakenHierarchy {
public:
    MistakenHierarchy(const Mesh<float>& mesh, Mistake mistake) : mistake_(mistake) {
        auto triangles = face_triangles(mesh);
        for (auto& triangle : triangles) triangle.face = renamed(triangle.face);
        tree_ = build_hierarchy(triangles, Cut::binned);
    }

    [[nodiscard]] std::optional<MeshHit<float>> nearest(const Ray<float>& ray,
                                                        Interval<float>   range = in_front<float>) const {
        NearestSearch<float> search(ray, range);
        walk(search, ray, tree_.root);
        auto hit = search.result();
        if (hit) hit->face = renamed(hit->face);
        return hit;
    }
    [[nodiscard]] bool occluded(const Ray<float>& ray) const { return nearest(ray).has_value(); }

private:
    void walk(NearestSearch<float>& search, const Ray<float>& ray, HierarchyNode<float>::Child here) const {
        for (std::uint32_t i = 0; i < here.count; ++i) search.offer(tree_.triangles[here.first + i]);
        if (here.count > 0) return;
        for (std::size_t side = 0; side < 2; ++side) {
            const Box<float>&     box    = tree_.nodes[here.first].box[side];
            const Interval<float> range  = search.range();
            const Interval<float> inside = mistake_ == Mistake::thin_boxes ? thin_clip(ray, box, range)
                                                                           : search.boxes().clip(box, range);
            const bool            pruned = mistake_ == Mistake::strict_pruning && inside.min >= range.max;
            if (!inside.empty() && !pruned) walk(search, ray, tree_.nodes[here.first].child[side]);
        }
    }

    static Interval<float> thin_clip(const Ray<float>& ray, const Box<float>& box, Interval<float> range) {
        for (int axis = 0; axis < 3; ++axis) {
            const float inverse = 1 / ray.direction[axis];
            const float a       = (box.min[axis] - ray.origin[axis]) * inverse;
            const float b       = (box.max[axis] - ray.origin[axis]) * inverse;
            if (std::isunordered(a, b)) continue;  // 0 * infinity: the ray runs in a face of the box
            range = {std::fmax(range.min, std::fmin(a, b)), std::fmin(range.max, std::fmax(a, b))};
        }
        return range;
    }

    /// In the opposite order the higher face is the lower one.
    [[nodiscard]] std::uint32_t renamed(std::uint32_t face) const {
        return mistake_ == Mistake::higher_face ? ~face : face;
    }

    Mistake              mistake_;
    HierarchyTree<float> tree_;
};

}  // namespace sr
