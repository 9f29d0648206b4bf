#pragma once
/// @file nearest.hpp
/// Which of many triangles does a ray meet first? The rule, and the plain way to apply it: ask them all.

#include <concepts>
#include <cstdint>
#include <optional>
#include <vector>

#include "geometry/box.hpp"
#include "geometry/mesh.hpp"
#include "geometry/ray.hpp"
#include "geometry/triangle.hpp"
#include "math/interval.hpp"

namespace sr {

/// Where a ray meets a mesh: as Hit, and the face that it meets.
template <std::floating_point T>
struct MeshHit {
    T             t;
    Vector2<T>    uv;
    std::uint32_t face;

    friend bool operator==(const MeshHit&, const MeshHit&) = default;
};

/// A triangle that knows which face of the mesh it is, so that triangles can be reordered.
template <std::floating_point T>
struct FaceTriangle {
    Triangle<T>   triangle;
    std::uint32_t face;
};

/// A mesh's triangles in the order of its faces.
template <std::floating_point T>
[[nodiscard]] std::vector<FaceTriangle<T>> face_triangles(const Mesh<T>& mesh) {
    std::vector<FaceTriangle<T>> triangles;
    triangles.reserve(mesh.faces.size());
    for (std::uint32_t face = 0; face < mesh.faces.size(); ++face)
        triangles.push_back({mesh.triangle(face), face});
    return triangles;
}

/// The search for the nearest hit of one ray. The answer does not depend on the order in which triangles are
/// offered: of equal t the lower face wins.
template <std::floating_point T>
class NearestSearch {
public:
    NearestSearch(const Ray<T>& ray, Interval<T> range)
        : triangles_(ray), boxes_(ray), asked_(range), range_(range) {}

    void offer(const FaceTriangle<T>& candidate) {
        const auto hit = triangles_.intersect(candidate.triangle, range_);
        if (!hit) return;
        // A hit lies in its triangle's box. To say so costs little, since few offers get here, and is what
        // makes a hierarchy, which looks into a box only where the ray is in it, find the same to the bit.
        const Interval<T> inside = boxes_.clip(bounds(candidate.triangle), asked_);
        const T           t      = hit->t > inside.min ? hit->t : inside.min;
        if (inside.empty() || !range_.contains(t)) return;
        if (best_ && t == best_->t && best_->face < candidate.face) return;
        best_      = MeshHit<T>{t, hit->uv, candidate.face};
        range_.max = t;
    }

    [[nodiscard]] const std::optional<MeshHit<T>>& result() const { return best_; }
    [[nodiscard]] const BoxRay<T>&                 boxes() const { return boxes_; }
    [[nodiscard]] Interval<T>                      range() const { return range_; }  ///< still of interest

private:
    TriangleRay<T>            triangles_;
    BoxRay<T>                 boxes_;
    Interval<T>               asked_;
    Interval<T>               range_;
    std::optional<MeshHit<T>> best_;
};

/// The triangles of a mesh in a list, asked one after the other: the reference for everything faster.
template <std::floating_point T>
class BruteForce {
public:
    explicit BruteForce(const Mesh<T>& mesh) : triangles_(face_triangles(mesh)) {}

    /// The hit with the least t in `range`, if there is one.
    [[nodiscard]] std::optional<MeshHit<T>> nearest(const Ray<T>& ray,
                                                    Interval<T>   range = in_front<T>) const {
        NearestSearch<T> search(ray, range);
        for (const auto& triangle : triangles_) search.offer(triangle);
        return search.result();
    }

private:
    std::vector<FaceTriangle<T>> triangles_;
};

}  // namespace sr
