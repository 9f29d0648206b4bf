#pragma once
/// @file radiosity_system.hpp

#include <vector>

#include "radiometry/spectrum.hpp"
#include "radiosity/form_factor_matrix.hpp"

namespace sr {

/// Radiosities of patches, in the three primaries at once [W/m^2].
using Radiosities = std::vector<DoubleSpectrum>;

/// B_i = E_i + rho_i sum_j F_ij B_j, equation (8.13): the radiosity B of each patch from those of all others. The three
/// primaries share the form factors and are solved together.
struct RadiositySystem {
    FormFactorMatrix            form_factors;
    std::vector<double>         area;         ///< [length unit^2]
    std::vector<DoubleSpectrum> reflectance;  ///< rho [1]
    Radiosities                 emission;     ///< E [W/m^2]

    [[nodiscard]] std::size_t size() const { return area.size(); }
};

/// 1 - rho_i F_ii, what a patch's radiosity is multiplied by in its own equation: less than 1 if it sees itself.
[[nodiscard]] inline DoubleSpectrum diagonal(const RadiositySystem& system, std::size_t i) {
    return DoubleSpectrum{1, 1, 1} - system.form_factors(i, i) * system.reflectance[i];
}

}  // namespace sr
