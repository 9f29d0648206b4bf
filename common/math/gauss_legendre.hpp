#pragma once
/// @file gauss_legendre.hpp

#include <cmath>
#include <numbers>
#include <vector>

namespace sr {

/// A point of a quadrature rule: the integral of f is about the sum of weight f(x).
struct QuadraturePoint {
    double x;
    double weight;
};

/// Gauss and Legendre's rule of n points over [from, to], exact for polynomials of degree 2n - 1. The points are
/// the roots of P_n, found by Newton's method from the usual start cos(pi (i - 1/4) / (n + 1/2)).
/// @pre n >= 1
/// @see Press et al., Numerical Recipes (2007), section 4.6.1
[[nodiscard]] inline std::vector<QuadraturePoint> gauss_legendre(int n, double from = -1, double to = 1) {
    std::vector<QuadraturePoint> rule;
    const double                 half = (to - from) / 2, middle = (from + to) / 2;
    for (int i = n; i >= 1; --i) {
        double x = std::cos(std::numbers::pi * (i - 0.25) / (n + 0.5)), slope = 1;
        for (int step = 0; step < 8; ++step) {
            double p = 1, before = 0;  // P_k(x) and P_k-1(x), from k = 0 on
            for (int k = 1; k <= n; ++k) {
                const double next = ((2 * k - 1) * x * p - (k - 1) * before) / k;
                before            = p;
                p                 = next;
            }
            slope = n * (x * p - before) / (x * x - 1);
            x -= p / slope;
        }
        rule.push_back({middle + half * x, half * 2 / ((1 - x * x) * slope * slope)});
    }
    return rule;
}

}  // namespace sr
