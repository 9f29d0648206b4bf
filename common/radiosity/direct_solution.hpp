#pragma once
/// @file direct_solution.hpp

#include "radiosity/radiosity_system.hpp"

namespace sr {

/// The radiosities by a factorisation of I - rho F for each primary: no iteration, and an error of rounding alone, some
/// units of the last digit times the condition 1 / (1 - rho). Costs n^3, and a second matrix: for hundreds of patches.
/// @pre the system has passed check_system
[[nodiscard]] Radiosities direct_solution(const RadiositySystem& system);

}  // namespace sr
