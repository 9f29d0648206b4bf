#pragma once
/// @file form_factors.hpp

#include <cstdint>

#include "radiosity/form_factor_matrix.hpp"
#include "radiosity/patches.hpp"
#include "radiosity/rows.hpp"
#include "radiosity/visibility.hpp"

namespace sr {

/// How exactly form factors are computed. Of patches that see each other whole, by the tolerance; of others, by the
/// standard error of their visible share as well, which is at most about 1 / (2 strata).
struct FormFactorSettings {
    double        tolerance = 1e-3;  ///< of an exchange area without visibility: see exchange_area()
    int           strata    = 4;     ///< visibility rays of a pair are the square of it
    std::uint64_t seed      = 1;     ///< of the points that they start from
};

/// All form factors between patches, equation (8.6): the exchange area of each pair, once, times its visible share. So
/// that A_i F_ij = A_j F_ji to rounding, whatever the rays find. The same for any number of threads.
/// @throws std::invalid_argument if the tolerance is not above 0 or there are no strata
[[nodiscard]] FormFactorMatrix form_factors(const Patches& patches, const Visibility& visibility,
                                            const FormFactorSettings& settings = {},
                                            const RowLoop&            loop     = {});

}  // namespace sr
