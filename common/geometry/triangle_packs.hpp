#pragma once
/// @file triangle_packs.hpp
/// A few triangles, asked eight at a time: as many numbers as a processor's register holds take part in one
/// instruction. A scene of a dozen walls needs no boxes.
///
///     const TrianglePacks<float> packs(mesh);
///     if (const auto hit = packs.nearest(ray)) shade(surface_point(mesh.triangle(hit->face), hit->uv));

#include <concepts>
#include <optional>
#include <vector>

#include "geometry/mesh.hpp"
#include "geometry/nearest.hpp"
#include "geometry/triangle.hpp"

namespace sr {

/// Keeps copies of the triangles: the mesh may go. Of float and double.
template <std::floating_point T>
class TrianglePacks {
public:
    explicit TrianglePacks(const Mesh<T>& mesh);

    /// The hit with the least t in `range`, of the lower face if there are two. It is BruteForce's, but where rounding
    /// decides: that one moves a hit into the box of its triangle, and here are no boxes.
    [[nodiscard]] std::optional<MeshHit<T>> nearest(const Ray<T>& ray, Interval<T> range = in_front<T>) const;

    /// Whether anything is hit in `range`.
    [[nodiscard]] bool occluded(const Ray<T>& ray, Interval<T> range = in_front<T>) const;

private:
    std::vector<Triangle<T>>     triangles_;
    std::vector<TrianglePack<T>> packs_;
};

}  // namespace sr
