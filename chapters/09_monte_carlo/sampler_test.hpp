#pragma once
/// @file sampler_test.hpp
/// Does a sampler draw from its density? Cells that should get as many samples each, and a chi-square test of how many
/// they got.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "moments.hpp"
#include "sampling/power_cosine.hpp"
#include "statistics/tests.hpp"

namespace sr {

/// The p-value of n directions that should follow cos^20, in 20 cells of their inverse.
/// @param exponent  with which they are drawn
[[nodiscard]] inline double lobe_p_value(double exponent, int n, std::uint64_t stream) {
    constexpr int              cells = 20;
    std::vector<std::uint64_t> counts(cells);
    Rng                        rng{93'000 + stream, n, 0, 0};
    for (int i = 0; i < n; ++i) {
        const auto   w = sample_power_cosine(draw_pair(rng), exponent);
        const double u = invert_power_cosine(w, 20.0).x;
        ++counts[std::min(std::size_t(u * cells), std::size_t(cells - 1))];
    }
    return chi_square_test(counts, std::vector<double>(cells, double(n) / cells)).p;
}

}  // namespace sr
