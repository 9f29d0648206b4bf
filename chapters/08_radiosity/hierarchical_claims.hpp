#pragma once
/// @file hierarchical_claims.hpp
/// What is said of hierarchical solutions, measured.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "cornell_meshes.hpp"
#include "course/chapter.hpp"
#include "random_walk.hpp"

namespace sr {

/// Leaves, links and errors as the bound gets tighter.
inline void claim_refinement(course::Chapter& chapter, const CornellMeshes& box,
                             const std::vector<HierarchicalSolution>& solutions,
                             const Radiosities&                       reference) {
    struct Row {
        double leaves, links, error;
    };
    const std::vector<Row>         expected{{152, 1130, 0.192}, {656, 8200, 0.110}, {3557, 57400, 0.0566}};
    const std::vector<const char*> bounds{"0.04", "0.01", "0.0025"};
    const auto claim = [&](const std::string& what, double value, double measured, double tolerance) {
        chapter.claim("8.8 " + what, {.expected = value, .measured = measured, .tolerance = tolerance});
    };
    for (std::size_t i = 0; i < expected.size(); ++i) {
        const auto& solution = solutions[i];
        claim(fmt::format("leaves, bound {}", bounds[i]), expected[i].leaves,
              double(solution.trees.leaf_count()), 0.5);
        claim(fmt::format("links, bound {}", bounds[i]), expected[i].links, double(solution.links.size()),
              i == 0 ? 5 : 50);
        claim(fmt::format("relative RMS error, bound {}", bounds[i]), expected[i].error,
              relative_rms(box.of_leaves(solution), reference), i == 2 ? 5e-5 : 5e-4);
    }
    const int  threads  = chapter.options().threads;
    const auto gathered = box.gathered(solutions.back(), threads);
    claim("relative RMS error, bound 0.0025, gathered", 0.0105, relative_rms(gathered, reference), 5e-5);
    const auto by_power = box.solution(6.25e-5, threads, LinkOracle::power);
    claim("links by power", 36700, double(by_power.links.size()), 50);
    claim("relative RMS error by power", 0.096, relative_rms(box.of_leaves(by_power), reference), 0.0005);
}

/// The radiosities of whole walls against a finer solution: root mean square, by area, and the worst.
inline void claim_means(course::Chapter& chapter, const CornellMeshes& box,
                        const HierarchicalSolution& solution, const HierarchicalSolution& finer) {
    const auto squared = [](DoubleSpectrum s) { return s.r * s.r + s.g * s.g + s.b * s.b; };
    double     error = 0, size = 0, worst = 0;
    for (std::size_t i = 0; i < box.polygons.size(); ++i) {
        const double area      = box.polygons[i].shape.area();
        const double wrong     = squared(solution.radiosities[i] - finer.radiosities[i]);
        const double reflected = squared(finer.radiosities[i] - box.polygons[i].emission);
        error += area * wrong;
        size += area * reflected;
        worst = std::max(worst, std::sqrt(wrong / reflected));
    }
    chapter.claim("8.8 relative RMS error of whole walls, bound 0.0025",
                  {.expected = 0.004, .measured = std::sqrt(error / size), .tolerance = 0.0005});
    chapter.claim("8.8 the worst wall, bound 0.0025",
                  {.expected = 0.024, .measured = worst, .tolerance = 0.0005});
}

/// Random walks from nine points against what is gathered there. That is darker: a node that lies half below a block has
/// the mean of both halves, and the half that is seen is the brighter one.
inline void claim_walks(course::Chapter& chapter, const CornellMeshes& box,
                        const HierarchicalSolution& finer) {
    const Patches   whole = cut(box.polygons, 1e4);
    const PatchView view(whole);
    const int       walks = course::ByQuality{.draft = 1 << 17, .lecture = 1 << 19, .print = 1 << 21}.at(
              chapter.options().quality);
    std::vector<SurfaceSample> points;
    for (const std::size_t i : {100, 400, 900, 1500, 2000, 2400, 2800, 3300, 3700})
        points.push_back(box.samples[i]);
    const auto   gathered = gathered_at(points, finer, box.visibility, 2, chapter.options().threads);
    course::Rows rows{{"point", "gathered B - E, green", "walked", "standard error"}};
    double       difference = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const auto&   p    = points[i];
        const double  rho  = box.polygons[p.polygon].reflectance.g;
        const Running walk = mean_walk(p, view, whole, walks, chapter.options().threads);
        difference += (gathered[i].g / (rho * walk.mean()) - 1) / double(points.size());
        rows.add({fmt::format("({:.0f}, {:.0f}, {:.0f})", p.position.x, p.position.y, p.position.z),
                  gathered[i].g, rho * walk.mean(), rho * walk.standard_error()});
    }
    chapter.say(rows);
    chapter.claim_at_most("8.8 gathered and walked, mean difference at nine points [%]",
                          std::abs(100 * difference), 5);
}

}  // namespace sr
