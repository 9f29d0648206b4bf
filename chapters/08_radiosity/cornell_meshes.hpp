#pragma once
/// @file cornell_meshes.hpp
/// The Cornell box, solved with meshes of all sizes and held against one reference.

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "course/timing.hpp"
#include "math/square.hpp"
#include "radiosity/form_factors.hpp"
#include "radiosity/gauss_seidel.hpp"
#include "radiosity/patch_system.hpp"
#include "radiosity/surface_samples.hpp"
#include "scene/cornell_box.hpp"

namespace sr {

/// The box, and points at which solutions are compared.
struct CornellMeshes {
    Scene                      scene    = cornell_box();
    std::vector<Polygon>       polygons = polygons_of(scene);
    Visibility                 visibility{scene.mesh};
    std::vector<SurfaceSample> samples = surface_samples(polygons, 4000, 7);

    [[nodiscard]] HierarchicalSolution solution(double bound, int threads,
                                                LinkOracle oracle = LinkOracle::error) const {
        return hierarchical_radiosity(polygons, visibility,
                                      {.bound = bound, .oracle = oracle, .threads = threads});
    }

    /// Gathered from a solution's links: closer to the truth than its leaves.
    [[nodiscard]] Radiosities gathered(const HierarchicalSolution& from, int threads) const {
        return gathered_at(samples, from, visibility, 2, threads);
    }

    /// Which polygon it is.
    [[nodiscard]] std::size_t lamp() const {
        const auto shines = [](const Polygon& polygon) { return polygon.emission != DoubleSpectrum{}; };
        return std::size_t(std::ranges::find_if(polygons, shines) - polygons.begin());
    }

    [[nodiscard]] Radiosities of_leaves(const HierarchicalSolution& of) const {
        return reflected_at(samples, of.trees.leaves(), of.trees.of_leaves(of.radiosities));
    }
};

/// What a solution took, and how wrong it is.
struct MeshCost {
    std::string method;
    std::size_t n;  ///< patches, or leaves
    double      seconds, mebibytes, error;
};

inline constexpr double mebibyte = 1 << 20;

inline MeshCost dense_cost(const CornellMeshes& box, double size, const Radiosities& reference) {
    const Patches patches = cut(box.polygons, size);
    Radiosities   radiosities;
    double        bytes   = 0;
    const double  seconds = course::seconds_of([&] {
        const auto system = system_of(patches, form_factors(patches, box.visibility));
        radiosities       = solution_by(GaussSeidel(system), 1e-4, 100);
        bytes             = square(double(system.size())) * sizeof(double);
    });
    return {"all pairs", patches.size(), seconds, bytes / mebibyte,
            relative_rms(reflected_at(box.samples, patches, radiosities), reference)};
}

inline MeshCost hierarchical_cost(const CornellMeshes& box, double bound, const Radiosities& reference) {
    std::optional<HierarchicalSolution> solution;
    const double seconds = course::seconds_of([&] { solution = box.solution(bound, 1); });
    return {"hierarchical", solution->trees.leaf_count(), seconds, double(solution->bytes()) / mebibyte,
            relative_rms(box.of_leaves(*solution), reference)};
}

}  // namespace sr
