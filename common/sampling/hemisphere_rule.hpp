#pragma once
/// @file hemisphere_rule.hpp

#include <cmath>
#include <numbers>
#include <vector>

#include "math/gauss_legendre.hpp"
#include "math/vector.hpp"

namespace sr {

/// A direction and the solid angle [sr] that it stands for.
struct WeightedDirection {
    Vector3<double> w;
    double          weight;
};

/// Directions above a surface whose normal is +z: the integral of f over the hemisphere is about the sum of weight
/// f(w). Gauss and Legendre's rule in z, which measures solid angle as the azimuth does, and equal steps of azimuth:
/// 2 n^2 directions, exact for polynomials in x, y, z of degree below 2n.
/// @pre n >= 1
[[nodiscard]] inline std::vector<WeightedDirection> hemisphere_rule(int n) {
    std::vector<WeightedDirection> rule;
    for (const auto& [z, weight] : gauss_legendre(n, 0, 1)) {
        const double r = std::sqrt((1 - z) * (1 + z));
        for (int k = 0; k < 2 * n; ++k) {
            const double phi = std::numbers::pi * (k + 0.5) / n;
            rule.push_back({{r * std::cos(phi), r * std::sin(phi), z}, weight * std::numbers::pi / n});
        }
    }
    return rule;
}

}  // namespace sr
