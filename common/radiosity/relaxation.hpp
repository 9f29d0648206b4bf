#pragma once
/// @file relaxation.hpp
/// For which lambda relaxed Jacobi converges. A step multiplies the error's part along each eigenvector of
/// D^-1 (I - rho F), D = diag(1 - rho_i F_ii), by 1 - lambda mu, equation (8.17), mu its eigenvalue.

#include <complex>
#include <vector>

#include "radiosity/radiosity_system.hpp"

namespace sr {

using Eigenvalues = std::vector<std::complex<double>>;

/// A primary: &DoubleSpectrum::r, g or b.
using Primary = double DoubleSpectrum::*;

/// All the mu of one primary, real up to rounding where factors are reciprocal. Costs n^3: for hundreds of patches.
[[nodiscard]] Eigenvalues jacobi_eigenvalues(const RadiositySystem& system,
                                             Primary                primary = &DoubleSpectrum::r);

/// What an error is multiplied by with each step, in the end: the largest |1 - lambda mu|.
[[nodiscard]] double spectral_radius(const Eigenvalues& eigenvalues, double lambda);

/// The steps converge for 0 < lambda < this, and 0 means for none, equation (8.18).
[[nodiscard]] double largest_stable_lambda(const Eigenvalues& eigenvalues);

/// The lambda with the smallest spectral radius, 2 / (mu_min + mu_max).
/// @pre the eigenvalues are real and positive: factors are reciprocal
[[nodiscard]] double best_lambda(const Eigenvalues& eigenvalues);

/// The same bound, for all three primaries, from products with F alone: mu_max by the power method, until a product
/// changes it by less than 1e-12, or after 1000 of them. Where the largest eigenvalues lie close together it may be
/// too large by some thousandths (of 7800 random systems six were by more than one, and none by four), see
/// check_relaxation.
/// @pre factors are reciprocal
[[nodiscard]] double estimated_stable_lambda(const RadiositySystem& system, int threads = 1);

/// A bound that is never too large, without any product: by Gershgorin's circles no mu is above
/// 1 + the largest rho_i (sum_j F_ij - F_ii) / (1 - rho_i F_ii). It is 1 or more where rho_i sum_j F_ij <= 1.
[[nodiscard]] double safe_lambda(const RadiositySystem& system);

/// Lets pass what is 1 at most, or below safe_lambda, or below the estimated bound by half a per cent.
/// @pre    the system has passed check_system; and, for a lambda above safe_lambda, factors are reciprocal
/// @throws std::invalid_argument with the lambda and the bound if the lambda is outside the stable range
void check_relaxation(const RadiositySystem& system, double lambda, int threads = 1);

}  // namespace sr
