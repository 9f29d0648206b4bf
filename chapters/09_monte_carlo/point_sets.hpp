#pragma once
/// @file point_sets.hpp
/// Section 9.6: points of the unit square, by pattern, and how well they share it out.

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "course/diagram.hpp"
#include "sampling/halton.hpp"
#include "sampling/random_point.hpp"
#include "sampling/sobol.hpp"
#include "sampling/sobol_point.hpp"
#include "sampling/stratified_point.hpp"

namespace sr {

struct PointSet {
    std::string                name;
    std::vector<course::Point> points;
};

/// The n points that `at` gives for 0, 1, ... n - 1.
template <class At>
[[nodiscard]] PointSet point_set(const std::string& name, std::uint32_t n, const At& at) {
    PointSet set{name, {}};
    for (std::uint32_t i = 0; i < n; ++i) set.points.push_back(at(i));
    return set;
}

/// The first pair of each of a pixel's n samples.
template <SamplePoint P>
[[nodiscard]] PointSet pattern_set(const std::string& name, std::uint32_t n) {
    return point_set(name, n, [&](std::uint32_t i) {
        return P({.seed = 1, .index = i, .count = n}).template pair<double>();
    });
}

/// Two coordinates of Halton's points, as they are.
[[nodiscard]] inline PointSet halton_set(const std::string& name, std::uint32_t n, std::size_t a,
                                         std::size_t b) {
    return point_set(name, n, [&](std::uint32_t i) { return course::Point{halton(i, a), halton(i, b)}; });
}

/// The first two coordinates of Sobol's points, as they are.
[[nodiscard]] inline PointSet sobol_set(const std::string& name, std::uint32_t n) {
    return point_set(name, n, [&](std::uint32_t i) {
        return course::Point{sobol(i, 0) * 0x1p-32, sobol(i, 1) * 0x1p-32};
    });
}

/// n points in each of six ways.
/// @pre n is a square number
[[nodiscard]] inline std::vector<PointSet> six_point_sets(std::uint32_t n) {
    return {pattern_set<RandomPoint>("random", n),
            pattern_set<StratifiedPoint>("jittered", n),
            halton_set("Halton, 2 and 3", n, 0, 1),
            halton_set("Halton, 29 and 31", n, 9, 10),
            sobol_set("Sobol'", n),
            pattern_set<SobolPoint>("Sobol', scrambled", n)};
}

/// How many of columns x rows equal boxes have a point.
[[nodiscard]] inline int boxes_hit(const std::vector<course::Point>& points, int columns, int rows) {
    std::vector<bool> hit(std::size_t(columns * rows));
    for (const auto& p : points) {
        const auto row = std::size_t(p.y * rows), column = std::size_t(p.x * columns);
        hit.at(row * std::size_t(columns) + column) = true;
    }
    int count = 0;
    for (const bool is_hit : hit) count += is_hit ? 1 : 0;
    return count;
}

}  // namespace sr
