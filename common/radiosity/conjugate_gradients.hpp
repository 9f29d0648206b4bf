#pragma once
/// @file conjugate_gradients.hpp

#include "radiosity/radiosity_solver.hpp"

namespace sr {

/// Row i of the system times A_i / rho_i is symmetric, equation (8.21), and conjugate gradients solve it, each of the
/// three primaries with steps of its own length. Where rho_i = 0 that row can't be made, and needs not be: there
/// B_i = E_i from the start and for good. The residual's preconditioner is the diagonal, as in Jacobi's method. A step
/// costs n^2.
/// @pre A_i F_ij = A_j F_ji, and the system has passed check_system: the matrix is positive definite
/// @see Hestenes and Stiefel, Methods of Conjugate Gradients for Solving Linear Systems (1952)
class ConjugateGradients {
public:
    /// @throws std::invalid_argument that names two patches between which F is not reciprocal
    explicit ConjugateGradients(const RadiositySystem& system, int threads = 1);
    explicit ConjugateGradients(const RadiositySystem&&, int = 1) = delete;  ///< it would be gone

    void step();

    [[nodiscard]] const Radiosities& radiosities() const { return radiosities_; }
    [[nodiscard]] double             residual() const;

private:
    /// sum_i A_i / rho_i s_i t_i
    [[nodiscard]] DoubleSpectrum product(const Radiosities& s, const Radiosities& t) const;
    [[nodiscard]] Radiosities    preconditioned() const;

    const RadiositySystem&      system_;
    int                         threads_;
    std::vector<DoubleSpectrum> weight_;  ///< A_i / rho_i, and 0 where rho_i is
    Radiosities                 radiosities_;
    Radiosities                 residuals_;
    Radiosities                 direction_;
    DoubleSpectrum              size_;  ///< of the residuals, squared
};

}  // namespace sr
