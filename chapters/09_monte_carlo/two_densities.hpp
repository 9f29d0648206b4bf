#pragma once
/// @file two_densities.hpp

#include <cmath>

#include "math/gauss_legendre.hpp"
#include "math/square.hpp"
#include "sampling/rng.hpp"

namespace sr {

/// How two samples of two densities are weighed against each other. For each x, the two weights add up to 1.
enum class Heuristic { balance, power };

/// The weight of a sample that was drawn with the density p, where the other one's is q.
[[nodiscard]] inline double weight_of(Heuristic heuristic, double p, double q) {
    return heuristic == Heuristic::balance ? p / (p + q) : square(p) / (square(p) + square(q));
}

/// x^2 over [0, 1] by one sample of p = 1 and one of p = 2x, equation (9.17).
[[nodiscard]] inline double draw_weighed_square(Heuristic heuristic, Rng& rng) {
    const double u = rng.uniform<double>(), x = std::sqrt(1 - rng.uniform<double>());
    return weight_of(heuristic, 1, 2 * u) * u * u + weight_of(heuristic, 2 * x, 1) * x * x / (2 * x);
}

/// The same by one sample of the mixture (1 + 2x) / 2: of either density, chosen by a coin.
[[nodiscard]] inline double draw_mixed_square(Rng& rng) {
    const bool   flat = rng.uniform<double>() < 0.5;
    const double u = rng.uniform<double>(), x = flat ? u : std::sqrt(u);
    return x * x / ((1 + 2 * x) / 2);
}

/// The variance of `draw_weighed_square`, by quadrature: the integrals of (w f / p)^2 p of both densities, less the
/// squares of those of w f.
[[nodiscard]] inline double variance_weighed(Heuristic heuristic) {
    double second = 0, first_1 = 0, first_2 = 0;
    for (const auto& [x, dx] : gauss_legendre(64, 0, 1)) {
        const double f = x * x, w_1 = weight_of(heuristic, 1, 2 * x), w_2 = weight_of(heuristic, 2 * x, 1);
        second += dx * square(f) * (square(w_1) + square(w_2) / (2 * x));
        first_1 += dx * w_1 * f;
        first_2 += dx * w_2 * f;
    }
    return second - square(first_1) - square(first_2);
}

/// That of `draw_mixed_square`, likewise.
[[nodiscard]] inline double variance_mixed() {
    double second = 0;
    for (const auto& [x, dx] : gauss_legendre(64, 0, 1)) second += dx * square(x * x) / ((1 + 2 * x) / 2);
    return second - 1.0 / 9;
}

}  // namespace sr
