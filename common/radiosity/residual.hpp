#pragma once
/// @file residual.hpp
/// What is wrong with radiosities: how much light the equations miss, or have too much.

#include <cstddef>

#include "radiosity/radiosity_system.hpp"

namespace sr {

/// sum_j F_ij B_j, the irradiance of patch i [W/m^2].
[[nodiscard]] DoubleSpectrum irradiance(const FormFactorMatrix& form_factors, const Radiosities& radiosities,
                                        std::size_t i);

/// B_i - rho_i sum_j F_ij B_j for all patches, (I - rho F) B [W/m^2]. Costs n^2, and the same bits for any `threads`.
[[nodiscard]] Radiosities applied(const RadiositySystem& system, const Radiosities& radiosities, int threads);

/// E - (I - rho F) B for all patches [W/m^2]: 0 where B solves (8.13).
[[nodiscard]] Radiosities residuals(const RadiositySystem& system, const Radiosities& radiosities,
                                    int threads);

/// How large the values are as a share of `whole`: the largest of one over the largest of the other, in the primary
/// where that is most. A primary in which both are 0 has none. NaN if anything is NaN.
[[nodiscard]] double relative_size(const Radiosities& values, const Radiosities& whole);

}  // namespace sr
