#pragma once
/// @file hierarchical_claims.hpp
/// What is said of hierarchical solutions, measured.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "cornell_meshes.hpp"
#include "course/chapter.hpp"
#include "light_walk.hpp"

namespace sr {

/// Leaves, links and errors as the bound gets tighter.
inline void claim_refinement(course::Chapter& chapter, const CornellMeshes& box,
                             const std::vector<HierarchicalSolution>& solutions,
                             const Radiosities&                       reference) {
    struct Row {
        double leaves, links, error;
    };
    const std::vector<Row>         expected{{146, 935, 0.195}, {644, 8800, 0.1081}, {3266, 59200, 0.0563}};
    const std::vector<const char*> bounds{"0.04", "0.01", "0.0025"};
    const auto claim = [&](const std::string& what, double value, double measured, double tolerance) {
        chapter.claim("8.8 " + what, {.expected = value, .measured = measured, .tolerance = tolerance});
    };
    for (std::size_t i = 0; i < std::min(expected.size(), solutions.size()); ++i) {
        const auto& solution = solutions[i];
        claim(fmt::format("leaves, bound {}", bounds[i]), expected[i].leaves,
              double(solution.trees.leaf_count()), 0.5);
        claim(fmt::format("links, bound {}", bounds[i]), expected[i].links, double(solution.links.size()),
              i == 0 ? 0.5 : 50);
        claim(fmt::format("relative RMS error, bound {}", bounds[i]), expected[i].error,
              relative_rms(box.of_leaves(solution), reference), i == 0 ? 5e-4 : 5e-5);
    }
    const int  threads  = chapter.options().threads;
    const auto gathered = box.gathered(solutions.back(), threads);
    claim("relative RMS error, bound 0.0025, gathered", 0.0108, relative_rms(gathered, reference), 5e-5);
    const auto by_power = box.solution(6.25e-5, threads, LinkOracle::power);
    claim("links by power", 36900, double(by_power.links.size()), 50);
    claim("relative RMS error by power", 0.096, relative_rms(box.of_leaves(by_power), reference), 0.0005);
}

/// Walls of a solution against walked ones, in green: relative and by area, the root mean square and the mean.
struct WallErrors {
    double rms, mean;
};

inline WallErrors wall_errors(const CornellMeshes& box, const HierarchicalSolution& solution,
                              const std::vector<Running>& walked) {
    double     error = 0, size = 0, difference = 0, sum = 0;
    WallErrors result{};
    for (std::size_t i = 0; i < walked.size(); ++i) {
        const double area = box.polygons[i].shape.area(), right = walked[i].mean();
        const double wrong = solution.radiosities[i].g - box.polygons[i].emission.g - right;
        error += area * square(wrong);
        size += area * square(right);
        difference += area * wrong;
        sum += area * right;
    }
    result.rms  = std::sqrt(error / size);
    result.mean = difference / sum;
    return result;
}

inline void claim_walls(course::Chapter& chapter, const CornellMeshes& box,
                        const HierarchicalSolution& solution, const HierarchicalSolution& finer) {
    const int walks = course::ByQuality{.draft = 1 << 20, .lecture = 1 << 22, .print = 1 << 23}.at(
        chapter.options().quality);
    const auto   right  = walked(cut(box.polygons, 1e4), box.lamp(), walks, chapter.options().threads);
    const auto   errors = wall_errors(box, solution, right), of_finer = wall_errors(box, finer, right);
    course::Rows rows{{"polygon", "B - E, green", "walked", "standard error"}};
    for (std::size_t i = 0; i < right.size(); ++i)
        rows.add({std::to_string(i), solution.radiosities[i].g - box.polygons[i].emission.g, right[i].mean(),
                  right[i].standard_error()});
    chapter.say(rows);
    chapter.claim("8.8 relative RMS error of whole walls, bound 0.0025 [%]",
                  {.expected = 1, .measured = 100 * errors.rms, .tolerance = 0.5});
    chapter.claim("8.8 light that is missing, bound 0.0025 [%]",
                  {.expected = 1, .measured = -100 * errors.mean, .tolerance = 0.5});
    chapter.claim("8.8 leaves, bound 0.001",
                  {.expected = 9554, .measured = double(finer.trees.leaf_count()), .tolerance = 0.5});
    chapter.claim_at_most("8.8 light that is missing, bound 0.001 [%]", -100 * of_finer.mean, 0.9);
}

}  // namespace sr
