#pragma once
/// @file catalogue.hpp

namespace sr::test {

/// Whether a failure is as frequent, or as large, as it is known to be: a rate depends on the rays that are drawn.
[[nodiscard]] constexpr bool within_factor_3(double measured, double known) {
    return measured >= known / 3 && measured <= 3 * known;
}

}  // namespace sr::test
