#pragma once
/// @file control_variate.hpp

#include <cmath>
#include <numbers>

#include "math/square.hpp"
#include "sampling/rng.hpp"

namespace sr {

/// The integral of e^x over [0, 1] by how it differs from beta (1 + x), whose integral is known: (9.16).
struct ExponentialLessLine {
    double beta;

    [[nodiscard]] double draw(Rng& rng) const {
        const double x = rng.uniform<double>();
        return std::exp(x) - beta * (1 + x) + 1.5 * beta;
    }

    /// Var f - 2 beta Cov(f, g) + beta^2 Var g of one draw, exactly.
    [[nodiscard]] double variance() const {
        using std::numbers::e;
        const double of_f = (square(e) - 1) / 2 - square(e - 1), of_g = 1.0 / 12;
        return of_f - 2 * beta * covariance + square(beta) * of_g;
    }

    /// Cov / Var g, where the variance is least.
    [[nodiscard]] static double best() { return 12 * covariance; }

private:
    static constexpr double covariance = 1 - (std::numbers::e - 1) / 2;
};

}  // namespace sr
