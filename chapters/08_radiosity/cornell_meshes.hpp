#pragma once
/// @file cornell_meshes.hpp
/// The Cornell box, solved with meshes of all sizes and held against one reference.

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "course/progress.hpp"
#include "course/timing.hpp"
#include "math/square.hpp"
#include "radiosity/form_factors.hpp"
#include "radiosity/gauss_seidel.hpp"
#include "radiosity/patch_system.hpp"
#include "radiosity/surface_samples.hpp"
#include "scene/cornell_box.hpp"
#include "told_to.hpp"

namespace sr {

/// About how many links are computed for a solution of the box, by an oracle of errors. Found by counting them, for
/// bounds from 0.016 to 0.0003.
[[nodiscard]] inline int expected_links(double bound) {
    return int(26 * std::pow(bound, -1.4));
}

/// The box, and points at which solutions are compared.
struct CornellMeshes {
    Scene                      scene    = cornell_box();
    std::vector<Polygon>       polygons = polygons_of(scene);
    Visibility                 visibility{scene.mesh};
    std::vector<SurfaceSample> samples = surface_samples(polygons, 4000, 7);

    [[nodiscard]] HierarchicalSolution solution(double bound, int threads,
                                                LinkOracle oracle = LinkOracle::error) const {
        const double     bound_of_errors = oracle == LinkOracle::error ? bound : 40 * bound;
        course::Progress progress("refining links", expected_links(bound_of_errors));
        return solution(bound, threads, oracle, progress);
    }

    /// @param progress  counts links
    [[nodiscard]] HierarchicalSolution solution(double bound, int threads, LinkOracle oracle,
                                                course::Progress& progress) const {
        return hierarchical_radiosity(
            polygons, visibility,
            {.bound = bound, .oracle = oracle, .threads = threads, .on_links = [&](int links) {
                 progress.tick(links);
             }});
    }

    /// Gathered from a solution's links: closer to the truth than its leaves.
    [[nodiscard]] Radiosities gathered(const HierarchicalSolution& from, int threads) const {
        course::Progress progress("gathering", steps_of_loop);
        return gathered_at(samples, from, visibility, 2, told_to(progress, threads));
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

/// @param progress  counts pairs of patches, which take about as long as links
inline MeshCost dense_cost(const CornellMeshes& box, double size, const Radiosities& reference,
                           course::Progress& progress) {
    const Patches patches = cut(box.polygons, size);
    Radiosities   radiosities;
    double        bytes = 0;
    const RowLoop rows{1, [&](int done, int of) { progress.tick(of - done); }};
    const double  seconds = course::seconds_of([&] {
        const auto system = system_of(patches, form_factors(patches, box.visibility, {}, rows));
        radiosities       = solution_by(GaussSeidel(system), 1e-4, 100);
        bytes             = square(double(system.size())) * sizeof(double);
    });
    return {"all pairs", patches.size(), seconds, bytes / mebibyte,
            relative_rms(reflected_at(box.samples, patches, radiosities), reference)};
}

/// @param progress  counts links
inline MeshCost hierarchical_cost(const CornellMeshes& box, double bound, const Radiosities& reference,
                                  course::Progress& progress) {
    std::optional<HierarchicalSolution> solution;
    const double                        seconds =
        course::seconds_of([&] { solution = box.solution(bound, 1, LinkOracle::error, progress); });
    return {"hierarchical", solution->trees.leaf_count(), seconds, double(solution->bytes()) / mebibyte,
            relative_rms(box.of_leaves(*solution), reference)};
}

}  // namespace sr
