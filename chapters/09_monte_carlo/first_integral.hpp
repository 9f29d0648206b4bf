#pragma once
/// @file first_integral.hpp
/// The integral of e^x from 0 to 2, and two densities to draw x from.

#include <cmath>

#include "math/gauss_legendre.hpp"
#include "math/square.hpp"
#include "sampling/linear.hpp"

namespace sr {

[[nodiscard]] inline double growth(double x) {
    return std::exp(x);
}

/// Of e^x from 0 to 2.
[[nodiscard]] inline double growth_integral() {
    return std::expm1(2.0);
}

/// All x alike: p = 1/2.
struct EvenDensity {
    [[nodiscard]] double sample(double u) const { return 2 * u; }
    [[nodiscard]] double pdf(double) const { return 0.5; }
};

/// p = (1 + 2x) / 6: larger where e^x is, and easier.
struct RisingDensity {
    [[nodiscard]] double sample(double u) const { return 2 * sample_linear(u, 1.0, 5.0); }
    [[nodiscard]] double pdf(double x) const { return pdf_linear(x / 2, 1.0, 5.0) / 2; }
};

/// Equation (9.3) with n = 1: the variance of e^X / p(X).
template <class Density>
[[nodiscard]] double growth_variance(const Density& p) {
    double squares = 0;
    for (const auto& [x, weight] : gauss_legendre(32, 0, 2)) squares += weight * square(growth(x)) / p.pdf(x);
    return squares - square(growth_integral());
}

}  // namespace sr
