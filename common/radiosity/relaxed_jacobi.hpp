#pragma once
/// @file relaxed_jacobi.hpp

#include "radiosity/radiosity_solver.hpp"

namespace sr {

/// All patches at once get their residual times lambda / (1 - rho_i F_ii), equation (8.16). From 0 and with lambda = 1
/// and F_ii = 0, k steps hold the light of fewer than k bounces. A step costs n^2.
/// @pre A_i F_ij = A_j F_ji if lambda is above safe_lambda, and 1: the bound is that of real eigenvalues
/// @see Cohen and Wallace, Radiosity and Realistic Image Synthesis (1993), chapter 5
class RelaxedJacobi {
public:
    /// @throws std::invalid_argument that names the bound if the lambda is outside the stable range, see relaxation.hpp
    explicit RelaxedJacobi(const RadiositySystem& system, double lambda = 1, int threads = 1);
    explicit RelaxedJacobi(const RadiositySystem&&, double = 1, int = 1) = delete;  ///< it would be gone

    void step();

    [[nodiscard]] const Radiosities& radiosities() const { return radiosities_; }
    [[nodiscard]] double             residual() const;

private:
    const RadiositySystem& system_;
    int                    threads_;
    double                 lambda_;
    Radiosities            radiosities_;
    Radiosities            residuals_;
};

}  // namespace sr
