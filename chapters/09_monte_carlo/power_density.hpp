#pragma once
/// @file power_density.hpp
/// Section 9.5: the integral of x^2 over [0, 1], drawn with powers of x.

#include <cmath>

#include "sampling/rng.hpp"

namespace sr {

/// p(x) = a x^(a-1) on [0, 1], by inversion.
/// @param a  more than 0
struct PowerDensity {
    double a;

    /// @param u  uniform in [0, 1); never 0 comes out, where f / p may be infinite
    [[nodiscard]] double sample(double u) const { return std::pow(1 - u, 1 / a); }
    [[nodiscard]] double pdf(double x) const { return a * std::pow(x, a - 1); }
};

/// What one sample of the integral counts, f / p.
[[nodiscard]] inline double square_over_pdf(const PowerDensity& p, double x) {
    return x * x / p.pdf(x);
}

[[nodiscard]] inline double draw_square(const PowerDensity& p, Rng& rng) {
    return square_over_pdf(p, p.sample(rng.uniform<double>()));
}

/// The variance of one sample in closed form, equation (9.15).
/// @pre 0 < a < 6, beyond which it is infinite
[[nodiscard]] inline double variance_of_square(double a) {
    return 1 / (a * (6 - a)) - 1.0 / 9;
}

}  // namespace sr
