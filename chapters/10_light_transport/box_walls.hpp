#pragma once
/// @file box_walls.hpp
/// Section 10.7: the walls of the Cornell box by both methods.

#include <fmt/format.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <string>
#include <string_view>
#include <vector>

#include "box_by_radiosity.hpp"
#include "course/chapter.hpp"
#include "course/claims.hpp"
#include "math/square.hpp"

namespace sr {

/// What a part of the box is called, and its polygons. The lamp is none of them.
struct BoxPart {
    std::string_view name;
    std::uint32_t    first, last;
};
inline constexpr std::uint32_t lamp_of_box = 6;
inline constexpr BoxPart       box_parts[] = {
          {"floor", 0, 0},    {"ceiling", 1, 1},      {"back wall", 2, 2},    {"green wall", 3, 3},
          {"red wall", 4, 5}, {"short block", 7, 11}, {"tall block", 12, 16}, {"all but the lamp", 0, 16}};

/// How much darker a part is by radiosity than by paths [%], with its standard error: the mean of differences at the
/// same points, which vary less than the light does.
/// @param reflected  at the points, by the leaves of a mesh
[[nodiscard]] inline Estimate missing_light(const BoxByRadiosity& box, const Radiosities& reflected,
                                            const std::vector<SurfaceSample>& points,
                                            const std::vector<Running>& by_paths, const BoxPart& part) {
    Running missing, light;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const auto polygon = points[i].polygon;
        if (polygon < part.first || polygon > part.last || polygon == lamp_of_box) continue;
        const double L = by_paths[i].mean() - box.polygons[polygon].emission.g;
        // both at the same point
        missing.add(L - reflected[i].g);
        light.add(L);
    }
    return {100 * missing.mean() / light.mean(), 100 * missing.standard_error() / light.mean()};
}

/// Root mean square over points, relative to that of the light there; the paths' own variance is taken off [%].
[[nodiscard]] inline double error_at_points(const BoxByRadiosity& box, const Radiosities& reflected,
                                            const std::vector<SurfaceSample>& points,
                                            const std::vector<Running>&       by_paths) {
    double squares = 0, all = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const double right = by_paths[i].mean() - box.polygons[points[i].polygon].emission.g;
        squares += square(reflected[i].g - right) - square(by_paths[i].standard_error());
        all += square(right);
    }
    return 100 * std::sqrt(squares / all);
}

/// Two meshes against 200 000 paths from all over the box, and against 400 from each of 500 points.
inline void compare_walls(course::Chapter& chapter, const BoxByRadiosity& box,
                          const HierarchicalSolution& coarse, const HierarchicalSolution& fine) {
    const int    threads  = chapter.options().threads;
    const auto   all_over = surface_samples(box.polygons, 200'000, 3);
    const auto   of_all   = box.by_paths(all_over, 1, threads);
    course::Rows rows{{"part", "missing, coarse mesh [%]", "missing, fine mesh [%]", "standard error [%]"}};
    const course::Claims claim{chapter, "10.7"};
    const auto           leaves_of_coarse = BoxByRadiosity::of_leaves(all_over, coarse),
               leaves_of_fine             = BoxByRadiosity::of_leaves(all_over, fine);
    for (const auto& part : box_parts) {
        const auto by_coarse = missing_light(box, leaves_of_coarse, all_over, of_all, part);
        const auto by_fine   = missing_light(box, leaves_of_fine, all_over, of_all, part);
        rows.add({std::string(part.name), by_coarse.value, by_fine.value, by_fine.error});
    }
    chapter.say(rows);
    const auto& all       = box_parts[std::size(box_parts) - 1];
    const auto  by_coarse = missing_light(box, leaves_of_coarse, all_over, of_all, all),
               by_fine    = missing_light(box, leaves_of_fine, all_over, of_all, all);
    claim("leaves, bound 0.01", 644, double(coarse.trees.leaf_count()), 0.5);
    claim("leaves, bound 0.0025", 3266, double(fine.trees.leaf_count()), 0.5);
    // to four of their standard errors, 0.2
    claim("light that is missing, 644 leaves [%]", 1, by_coarse.value, 0.8);
    claim("light that is missing, 3266 leaves [%]", 0.7, by_fine.value, 0.8);
    claim("standard error of what is missing [%]", 0.2, by_fine.error, 0.05);

    const auto points   = surface_samples(box.polygons, 500, 7);
    const auto by_paths = box.by_paths(points, 400, threads);
    claim("error at points, leaves [%]", 6,
          error_at_points(box, BoxByRadiosity::of_leaves(points, fine), points, by_paths), 1);
    chapter.claim_at_most("10.7 error at points, gathered [%]",
                          error_at_points(box, box.gathered(points, fine, threads), points, by_paths), 2.5);
}

}  // namespace sr
