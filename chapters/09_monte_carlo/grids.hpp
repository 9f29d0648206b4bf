#pragma once
/// @file grids.hpp
/// Section 9.8: quadrature in many dimensions, by a rule of few points along each.

#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

#include "math/gauss_legendre.hpp"

namespace sr {

/// The middles of n equal parts of [0, 1].
[[nodiscard]] inline std::vector<QuadraturePoint> midpoint_rule(int n) {
    std::vector<QuadraturePoint> rule;
    for (int i = 0; i < n; ++i) rule.push_back({(i + 0.5) / n, 1.0 / n});
    return rule;
}

/// How many points a grid has along each of d axes if it has n at most: k along some and k + 1 along the others.
/// @pre n >= 1, d >= 1
[[nodiscard]] inline std::vector<int> grid_sides(int n, int d) {
    const auto points = [&](int k) { return std::pow(double(k), d); };
    int        k      = 1;
    while (points(k + 1) <= n) ++k;
    std::vector<int> sides(std::size_t(d), k);
    double           all = points(k);
    for (int& side : sides) {
        if (all * (k + 1) / k > n) break;
        all *= double(k + 1) / k;
        side = k + 1;
    }
    return sides;
}

/// The integral of f over the unit cube by a rule along each axis: as many values of f as the product of the sides.
/// @param rule  (int n) -> the points of the rule of n points on [0, 1]
/// @param f     (std::span<const double> x) -> value
template <class Rule, class F>
[[nodiscard]] double grid_integral(const std::vector<int>& sides, const Rule& rule, const F& f) {
    std::vector<std::vector<QuadraturePoint>> axes;
    for (const int side : sides) axes.push_back(rule(side));
    std::vector<std::size_t> place(sides.size(), 0);
    std::vector<double>      x(sides.size());
    double                   sum = 0;
    for (std::size_t axis = 0; axis < sides.size();) {  // all places, as an odometer shows them
        double weight = 1;
        for (std::size_t k = 0; k < sides.size(); ++k) {
            x[k] = axes[k][place[k]].x;
            weight *= axes[k][place[k]].weight;
        }
        sum += weight * f(std::span<const double>(x));
        for (axis = 0; axis < sides.size() && ++place[axis] == axes[axis].size(); ++axis) place[axis] = 0;
    }
    return sum;
}

}  // namespace sr
