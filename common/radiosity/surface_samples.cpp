/// @file surface_samples.cpp

#include "radiosity/surface_samples.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

#include "radiosity/patch_view.hpp"
#include "radiosity/point_form_factors.hpp"
#include "radiosity/point_pairs.hpp"
#include "sampling/rng.hpp"

namespace sr {
namespace {

using Point = Vector3<double>;

/// How far a point of the plane lies in a patch: the least of its distances to the sides, negative outside.
double depth(const Patch& patch, const Point& point) {
    const auto p     = patch.corners();
    double     least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < p.size(); ++i) {
        const Vector3<double> side = p[(i + 1) % p.size()] - p[i];
        least = std::min(least, dot(patch.normal(), cross(side, point - p[i])) / length(side));
    }
    return least;
}

/// The child that holds the point; of two at their common side, either.
std::uint32_t child_at(const Quadtrees& trees, std::uint32_t node, const Point& point) {
    const std::uint32_t first = trees[node].first_child;
    std::uint32_t       best  = first;
    for (std::uint32_t k = first + 1; k < first + 4; ++k)
        if (depth(trees[k].shape, point) > depth(trees[best].shape, point)) best = k;
    return best;
}

/// The links by which light gets to each node: those of node i are all[first[i]] to all[first[i + 1]].
struct LinksByReceiver {
    std::vector<RadiosityLink> all;
    std::vector<std::size_t>   first;
};

LinksByReceiver by_receiver(const HierarchicalSolution& solution) {
    const auto&              links = solution.links;
    std::vector<std::size_t> first(solution.trees.size() + 1);
    for (const auto& link : links) ++first[link.receiver + 1];
    for (std::size_t i = 1; i < first.size(); ++i) first[i] += first[i - 1];
    std::vector<RadiosityLink> sorted(links.size());
    auto                       next = first;
    for (const auto& link : links) sorted[next[link.receiver]++] = link;
    return {std::move(sorted), std::move(first)};
}

/// Mean radiosity of the quarters on which rays from a point to strata of a node end, as the form factor weighs them;
/// what is hidden is black.
DoubleSpectrum seen_from(const SurfacePoint<double>& from, std::uint32_t node,
                         const HierarchicalSolution& solution, const Visibility& visibility, int side,
                         Rng& rng) {
    const Patch&   to      = solution.trees[node].shape;
    const bool     is_leaf = solution.trees[node].is_leaf();
    double         all     = 0;
    DoubleSpectrum seen;
    for (const auto& q : stratified_points(to, side, rng)) {
        const double weight = form_factor_kernel(from.position, from.normal, q, to.normal());
        all += weight;
        if (weight > 0 && visibility.between(from, to.surface_point(q)))
            seen = seen + weight * solution.radiosities[is_leaf ? node : child_at(solution.trees, node, q)];
    }
    return all > 0 ? seen / all : solution.radiosities[node];
}

}  // namespace

std::vector<SurfaceSample> surface_samples(std::span<const Polygon> polygons, int count, std::uint64_t seed) {
    double area = 0;
    for (const auto& polygon : polygons) area += polygon.shape.area();
    std::vector<SurfaceSample> samples;
    double                     passed = 0;  // area of the polygons so far
    for (std::uint32_t i = 0; i < polygons.size(); ++i) {
        passed += polygons[i].shape.area();
        while (int(samples.size()) < count && (double(samples.size()) + 0.5) / count < passed / area) {
            Rng          rng{seed, std::int64_t(samples.size()), 0, 0};
            const double u = rng.uniform<double>(), v = rng.uniform<double>();
            samples.push_back({polygons[i].shape.sample({u, v}), polygons[i].shape.normal(), i});
        }
    }
    return samples;
}

Radiosities reflected_at(std::span<const SurfaceSample> samples, const Patches& patches,
                         const Radiosities& radiosities) {
    const PatchView view(patches);
    Radiosities     result;
    for (const auto& [position, normal, polygon] : samples) {
        constexpr double above = 1e-6;  // part of the coordinates
        const Point      eye   = position + above * size_of(position) * normal;
        const auto       seen  = view.seen({eye, -normal});
        if (!seen || patches.polygon[seen->patch] != polygon)
            throw std::invalid_argument(fmt::format("no patch of polygon {} at ({}, {}, {})", polygon,
                                                    position.x, position.y, position.z));
        result.push_back(radiosities[seen->patch] - patches.emission[seen->patch]);
    }
    return result;
}

Radiosities gathered_at(std::span<const SurfaceSample> samples, const HierarchicalSolution& solution,
                        const Visibility& visibility, int strata, const RowLoop& loop) {
    const LinksByReceiver links = by_receiver(solution);
    Radiosities           result(samples.size());
    for_each_row(samples.size(), loop, [&](std::size_t i) {
        const auto& [position, normal, polygon] = samples[i];
        const auto&    trees                    = solution.trees;
        const auto     from                     = trees[polygon].shape.surface_point(position);
        DoubleSpectrum irradiance;
        for (std::uint32_t node = polygon;; node = child_at(trees, node, position)) {
            for (std::size_t k = links.first[node]; k < links.first[node + 1]; ++k) {
                const std::uint32_t source  = links.all[k].source;
                const bool          is_lamp = trees.polygon_of(source).emission != DoubleSpectrum{};
                Rng                 rng{1, std::int64_t(i), source, 0};
                const double        factor = contour_form_factor(position, normal, trees[source].shape);
                if (!(factor > 0)) continue;
                irradiance = irradiance + factor * seen_from(from, source, solution, visibility,
                                                             is_lamp ? 4 * strata : strata, rng);
            }
            if (trees[node].is_leaf()) break;
        }
        result[i] = trees.polygon_of(polygon).reflectance * irradiance;
    });
    return result;
}

double relative_rms(const Radiosities& measured, const Radiosities& reference) {
    const auto squared = [](DoubleSpectrum s) { return s.r * s.r + s.g * s.g + s.b * s.b; };
    double     error = 0, size = 0;
    for (std::size_t i = 0; i < reference.size(); ++i) {
        error += squared(measured[i] - reference[i]);
        size += squared(reference[i]);
    }
    return std::sqrt(error / size);
}

}  // namespace sr
