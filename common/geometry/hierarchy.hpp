#pragma once
/// @file hierarchy.hpp
/// A hierarchy of boxes over a mesh's triangles: which of them does a ray meet first?
///
///     const Hierarchy<float> hierarchy(mesh);
///     if (const auto hit = hierarchy.nearest(ray)) shade(surface_point(mesh.triangle(hit->face), hit->uv));
///     if (hierarchy.occluded(ray, {0, distance})) ...

#include <concepts>
#include <cstdint>
#include <limits>
#include <optional>
#include <utility>

#include "geometry/hierarchy_build.hpp"
#include "geometry/hierarchy_node.hpp"
#include "geometry/hierarchy_walk.hpp"
#include "geometry/nearest.hpp"

namespace sr {

/// How a hierarchy is built. No choice changes a hit.
struct HierarchyOptions {
    Cut cut = Cut::binned;

    /// So few triangles are asked one after the other: boxes would cost a ray more than they save. Figure 4.8
    /// is where this number comes from.
    std::uint32_t asked_straight = 3;
};

/// Keeps copies of the triangles: the mesh may go. Distances t, and ranges of them, count in units of |d|.
template <std::floating_point T>
class Hierarchy {
public:
    /// @pre the faces' indices are those of vertices; a triangle that is not finite is never hit
    explicit Hierarchy(const Mesh<T>& mesh, HierarchyOptions options = {}) {
        auto triangles = face_triangles(mesh);
        if (triangles.size() > options.asked_straight) {
            tree_ = build_hierarchy(triangles, options.cut);
        } else {
            tree_.root      = {0, std::uint32_t(triangles.size())};
            tree_.triangles = std::move(triangles);
        }
    }

    /// The hit with the least t in `range`, the same to the bit as BruteForce's.
    /// @pre range.min >= 0; a ray that is not finite hits nothing
    [[nodiscard]] std::optional<MeshHit<T>> nearest(const Ray<T>& ray,
                                                    Interval<T>   range = in_front<T>) const {
        Uncounted uncounted;
        return nearest(ray, range, uncounted);
    }

    /// The same, and counts what it took.
    [[nodiscard]] std::optional<MeshHit<T>> nearest(const Ray<T>& ray, Interval<T> range, auto& count) const {
        NearestSearch<T> search(ray, range);
        walk(tree_, search, count);
        return search.result();
    }

    /// Whether anything is hit in `range`; stops at the first leaf with a hit.
    /// @pre range.min >= 0
    [[nodiscard]] bool occluded(const Ray<T>& ray, Interval<T> range = in_front<T>) const {
        AnySearch search{NearestSearch<T>(ray, range)};
        Uncounted uncounted;
        walk(tree_, search, uncounted);
        return search.result().has_value();
    }

    [[nodiscard]] const HierarchyTree<T>& tree() const { return tree_; }

private:
    /// Has seen enough after the first hit.
    struct AnySearch : NearestSearch<T> {
        [[nodiscard]] Interval<T> range() const {
            constexpr T infinity = std::numeric_limits<T>::infinity();
            return this->result() ? Interval<T>{infinity, -infinity} : NearestSearch<T>::range();
        }
    };

    HierarchyTree<T> tree_;
};

}  // namespace sr
