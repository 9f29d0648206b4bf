/// @file relaxation.cpp

#include "radiosity/relaxation.hpp"

#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "math/extremes.hpp"
#include "radiosity/residual.hpp"
#include "sampling/rng.hpp"

namespace sr {
namespace {

/// D^-1 (I - rho F) times a vector.
Radiosities jacobi_image(const RadiositySystem& system, const Radiosities& vector, int threads) {
    Radiosities image = applied(system, vector, threads);
    for (std::size_t i = 0; i < image.size(); ++i) image[i] = image[i] / diagonal(system, i);
    return image;
}

/// Divides by the root of the sum of squares, for each primary, and returns it. By the largest magnitude instead, a
/// black patch, which no product changes, would make it seem for a while that nothing changes.
DoubleSpectrum normalise(Radiosities& vector) {
    DoubleSpectrum squares;
    for (const auto& value : vector) squares = squares + value * value;
    const DoubleSpectrum root{std::sqrt(squares.r), std::sqrt(squares.g), std::sqrt(squares.b)};
    for (auto& value : vector) value = value / root;
    return root;
}

/// Numbers that no eigenvector is likely to be at right angles to, the same each time.
Radiosities start_vector(std::size_t n) {
    Rng         rng{1, 0, 0, 0};
    Radiosities vector(n);
    for (auto& value : vector) {
        const double x = 2 * rng.uniform<double>() - 1;
        value          = {x, x, x};
    }
    return vector;
}

}  // namespace

Eigenvalues jacobi_eigenvalues(const RadiositySystem& system, Primary primary) {
    const auto      n = Eigen::Index(system.size());
    Eigen::MatrixXd matrix(n, n);
    for (Eigen::Index i = 0; i < n; ++i) {
        const double rho = system.reflectance[std::size_t(i)].*primary;
        const double own = diagonal(system, std::size_t(i)).*primary;
        for (Eigen::Index j = 0; j < n; ++j)
            matrix(i, j) = i == j ? 1 : -rho * system.form_factors(std::size_t(i), std::size_t(j)) / own;
    }
    const Eigen::EigenSolver<Eigen::MatrixXd> solver(matrix, false);
    return {solver.eigenvalues().begin(), solver.eigenvalues().end()};
}

double spectral_radius(const Eigenvalues& eigenvalues, double lambda) {
    double most = 0;
    for (const auto& mu : eigenvalues) most = max_or_nan(most, std::abs(1.0 - lambda * mu));
    return most;
}

double largest_stable_lambda(const Eigenvalues& eigenvalues) {
    // |1 - lambda mu| < 1 where lambda |mu|^2 < 2 Re mu
    double least = HUGE_VAL;
    for (const auto& mu : eigenvalues) least = min_or_nan(least, 2 * mu.real() / std::norm(mu));
    return std::max(least, 0.0);
}

double best_lambda(const Eigenvalues& eigenvalues) {
    double least = HUGE_VAL, most = 0;
    for (const auto& mu : eigenvalues) {
        least = min_or_nan(least, mu.real());
        most  = max_or_nan(most, mu.real());
    }
    return 2 / (least + most);
}

double estimated_stable_lambda(const RadiositySystem& system, int threads) {
    Radiosities    vector = start_vector(system.size());
    DoubleSpectrum grown;
    normalise(vector);
    for (int i = 0; i < 1000; ++i) {
        vector                   = jacobi_image(system, vector, threads);
        const DoubleSpectrum now = normalise(vector), change = now - grown;
        grown = now;
        if (each_in(change, -1e-12, 1e-12)) break;
    }
    return 2 / largest(grown);
}

double safe_lambda(const RadiositySystem& system) {
    double radius = 0;
    for (std::size_t i = 0; i < system.size(); ++i) {
        const double others = system.form_factors.row_sum(i) - system.form_factors(i, i);
        radius = max_or_nan(radius, largest(others * system.reflectance[i] / diagonal(system, i)));
    }
    return 2 / (1 + radius);
}

void check_relaxation(const RadiositySystem& system, double lambda, int threads) {
    if (lambda > 0 && lambda <= 1) return;  // the light of one bounce more, or a part of it
    const double safe = safe_lambda(system);
    if (lambda > 0 && lambda < safe) return;
    // The estimate may be too large by some thousandths, and steps that grow slowly overflow as well.
    const double bound = std::max(safe, 0.995 * estimated_stable_lambda(system, threads));
    if (lambda > 0 && lambda < bound) return;
    throw std::invalid_argument(
        fmt::format("lambda is {}; must be above 0 and below {:.4g}, or the steps of relaxed Jacobi grow",
                    lambda, bound));
}

}  // namespace sr
