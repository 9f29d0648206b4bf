/// @file triangle_packs.cpp
/// In a file of its own, where a compiler puts the few lines of a loop into one another and sees that its eight rounds
/// are alike.

#include "geometry/triangle_packs.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>

namespace sr {
namespace {

template <std::floating_point T>
constexpr T nowhere = std::numeric_limits<T>::infinity();

template <std::floating_point T>
constexpr std::size_t lanes = TrianglePack<T>::lanes;

/// The nearest hit of each lane, and in which pack.
template <std::floating_point T>
struct Best {
    std::array<T, lanes<T>>             t;
    std::array<std::uint32_t, lanes<T>> pack = {};

    Best() { t.fill(nowhere<T>); }

    [[nodiscard]] std::optional<std::uint32_t> face() const {
        const T least = *std::ranges::min_element(t);
        if (!(least < nowhere<T>)) return std::nullopt;
        std::uint32_t first = std::numeric_limits<std::uint32_t>::max();
        for (std::uint32_t lane = 0; lane < t.size(); ++lane)
            if (t[lane] == least) first = std::min(first, std::uint32_t(pack[lane] * t.size() + lane));
        return first;
    }
};

}  // namespace

template <std::floating_point T>
TrianglePacks<T>::TrianglePacks(const Mesh<T>& mesh) {
    for (std::size_t face = 0; face < mesh.faces.size(); ++face) {
        if (face % lanes<T> == 0) packs_.emplace_back();
        triangles_.push_back(mesh.triangle(face));
        packs_.back().set(face % lanes<T>, triangles_.back());
    }
}

template <std::floating_point T>
std::optional<MeshHit<T>> TrianglePacks<T>::nearest(const Ray<T>& ray, Interval<T> range) const {
    const TriangleRay<T> seen(ray);
    Best<T>              best;
    for (std::uint32_t i = 0; i < packs_.size(); ++i)
        seen.each_lane(packs_[i], range, [&](std::size_t lane, T t) {
            const bool nearer = t < best.t[lane];
            best.t[lane]      = nearer ? t : best.t[lane];
            best.pack[lane]   = nearer ? i : best.pack[lane];
        });
    const auto face = best.face();
    if (!face) return std::nullopt;
    const auto hit = seen.intersect(triangles_[*face], range);
    return MeshHit<T>{hit->t, hit->uv, *face};
}

template <std::floating_point T>
bool TrianglePacks<T>::occluded(const Ray<T>& ray, Interval<T> range) const {
    const TriangleRay<T>    seen(ray);
    std::array<T, lanes<T>> nearest;
    nearest.fill(nowhere<T>);
    for (const auto& pack : packs_)
        seen.each_lane(pack, range,
                       [&](std::size_t lane, T t) { nearest[lane] = std::min(nearest[lane], t); });
    return *std::ranges::min_element(nearest) < nowhere<T>;
}

template class TrianglePacks<float>;
template class TrianglePacks<double>;

}  // namespace sr
