#pragma once
/// @file closure.hpp
/// In a closed scene all light arrives somewhere, and the form factors of a row add up to 1, equation (8.8). Computed
/// ones don't quite; and what is too much or too little in a row is so in every bounce.

#include "radiosity/form_factor_matrix.hpp"

namespace sr {

/// The largest |row sum - 1|.
[[nodiscard]] double closure_defect(const FormFactorMatrix& form_factors);

/// Each row divided by its sum. Rows then add up to 1, but A_i F_ij = A_j F_ji is lost.
/// @throws std::invalid_argument that names a patch that sees nothing
[[nodiscard]] FormFactorMatrix with_normalised_rows(FormFactorMatrix form_factors);

/// d_i F_ij d_j, with a number d_i for each patch such that rows add up to 1 within `tolerance`: A_i F_ij, where it
/// is symmetric, stays so, and the factors keep both laws. Only for closed scenes: of others, the missing light is
/// not the factors' fault.
/// @throws std::invalid_argument that names a patch that sees nothing
/// @throws std::runtime_error    if the rows are still farther off after 1000 rounds, as where the light of some
///                               patches can only go to a smaller area than theirs
/// @see    Knight, Ruiz and Ucar, A Symmetry Preserving Algorithm for Matrix Scaling, SIAM J. Matrix Anal. Appl. 35
///         (2014)
[[nodiscard]] FormFactorMatrix symmetrically_scaled(FormFactorMatrix form_factors, double tolerance = 1e-12);

}  // namespace sr
