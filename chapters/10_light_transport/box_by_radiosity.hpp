#pragma once
/// @file box_by_radiosity.hpp
/// Section 10.7: the Cornell box by chapter 8's method and by paths, point by point.

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

#include "course/progress.hpp"
#include "path_means.hpp"
#include "radiosity/hierarchical_radiosity.hpp"
#include "radiosity/surface_samples.hpp"
#include "scene/cornell_box.hpp"
#include "transport/path_tracer.hpp"

namespace sr {

/// The box as both methods know it, and radiosities of its hierarchical solution.
struct BoxByRadiosity {
    Scene                scene    = cornell_box();
    std::vector<Polygon> polygons = polygons_of(scene);
    Visibility           visibility{scene.mesh};
    PathTracer           paths{scene};

    [[nodiscard]] HierarchicalSolution solution(double bound, int threads) const {
        // as many links as were counted for bounds from 0.016 to 0.0003
        course::Progress progress("refining links", int(26 * std::pow(bound, -1.4)));
        return hierarchical_radiosity(
            polygons, visibility,
            {.bound = bound, .threads = threads, .on_links = [&](int links) { progress.tick(links); }});
    }

    /// What is reflected at points, as the mesh has it: one value for each of its leaves [W/m^2].
    [[nodiscard]] static Radiosities of_leaves(const std::vector<SurfaceSample>& points,
                                               const HierarchicalSolution&       solution) {
        return reflected_at(points, solution.trees.leaves(), solution.trees.of_leaves(solution.radiosities));
    }

    /// The same gathered once more from all that the point sees [W/m^2].
    [[nodiscard]] Radiosities gathered(const std::vector<SurfaceSample>& points,
                                       const HierarchicalSolution& solution, int threads) const {
        constexpr int    steps = 1000;
        course::Progress progress("gathering", steps);
        return gathered_at(points, solution, visibility, 2,
                           {.threads = threads, .on_row = [&](int done, int of) {
                                progress.tick(course::steps_of_part(steps, done, of));
                            }});
    }

    /// The green radiosity there by one path, emission included [W/m^2]: pi times the radiance, that is the same in all
    /// directions.
    [[nodiscard]] double by_path(const Vector3<double>& position, const Vector3<double>& normal,
                                 RandomPoint& point) const {
        constexpr double before = 0.02;  // [mm], from where the surface is looked at: the lamp's gap is 0.1
        const Ray<float> ray{Vec3(position + before * normal), Vec3(-normal)};
        PathCount        count;
        return std::numbers::pi * double(paths.radiance(ray, point, count).g);
    }

    /// The green radiosity at points by so many paths each [W/m^2].
    [[nodiscard]] std::vector<Running> by_paths(const std::vector<SurfaceSample>& points, int each,
                                                int threads) const {
        std::vector<Running> means(points.size());
        for_each_row(points.size(), {.threads = threads}, [&](std::size_t i) {
            for (int k = 0; k < each; ++k) {
                RandomPoint point(SampleId{.x = std::int32_t(i), .index = std::uint32_t(k)});
                means[i].add(by_path(points[i].position, points[i].normal, point));
            }
        });
        return means;
    }
};

}  // namespace sr
