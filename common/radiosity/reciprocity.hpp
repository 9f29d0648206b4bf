#pragma once
/// @file reciprocity.hpp
/// A_i F_ij = A_j F_ji, equation (8.7): between two patches as much light goes one way as the other.

#include <span>

#include "radiosity/form_factor_matrix.hpp"

namespace sr {

/// The largest |A_i F_ij - A_j F_ji| as a share of the smaller area: by so much a form factor may be wrong [1].
[[nodiscard]] double reciprocity_defect(const FormFactorMatrix& form_factors, std::span<const double> area);

/// A_i F_ij and A_j F_ji each replaced by their mean: reciprocal, and as close to what was there as that can be. But
/// rows that summed to 1 don't any more: what is wrong with a factor is now also in the other one.
[[nodiscard]] FormFactorMatrix symmetrised(const FormFactorMatrix& form_factors,
                                           std::span<const double> area);

/// @throws std::invalid_argument that names two patches between which reciprocity fails by more than the tolerance
void check_reciprocity(const FormFactorMatrix& form_factors, std::span<const double> area,
                       double tolerance = 1e-9);

}  // namespace sr
