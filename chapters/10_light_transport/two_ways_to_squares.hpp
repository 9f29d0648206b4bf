#pragma once
/// @file two_ways_to_squares.hpp
/// Section 10.3: x^2 over [0, 1] by two samples, the variances of section 9.5 by quadrature (row H14).

#include "course/claims.hpp"
#include "math/gauss_legendre.hpp"
#include "math/square.hpp"

namespace sr {

/// The variance of one sample of p = 1 and one of q = 2x, each weighed.
/// @param weight  (double p, double q) -> that of a sample that was drawn with the density p
template <class Weight>
[[nodiscard]] double variance_by_both(const Weight& weight) {
    double second = 0, by_p = 0, by_q = 0;
    for (const auto& [x, dx] : gauss_legendre(64, 0, 1)) {
        const double f = square(x), p = 1, q = 2 * x;
        second += dx * (square(weight(p, q) * f) / p + square(weight(q, p) * f) / q);
        by_p += dx * weight(p, q) * f;
        by_q += dx * weight(q, p) * f;
    }
    return second - square(by_p) - square(by_q);
}

/// That of two samples of one density.
template <class Density>
[[nodiscard]] double variance_of_two(const Density& density) {
    double second = 0;
    for (const auto& [x, dx] : gauss_legendre(64, 0, 1)) second += dx * square(square(x)) / density(x);
    return (second - 1.0 / 9) / 2;
}

inline void claim_two_ways_to_squares(course::Chapter& chapter) {
    const course::Claims claim{chapter, "10.3"};
    claim("x^2, two of p = 1: variance", 0.04444, variance_of_two([](double) { return 1; }), 5e-6);
    claim("x^2, two of q = 2x: variance", 0.00694, variance_of_two([](double x) { return 2 * x; }), 5e-6);
    claim("x^2, two of the mixture: variance", 0.02044,
          variance_of_two([](double x) { return (1 + 2 * x) / 2; }), 5e-6);
    claim("x^2, one of each, balance: variance", 0.01872,
          variance_by_both([](double p, double q) { return p / (p + q); }), 5e-6);
    claim("x^2, one of each, power: variance", 0.01818,
          variance_by_both([](double p, double q) { return square(p) / (square(p) + square(q)); }), 5e-6);
}

}  // namespace sr
