/// @file closure.cpp

#include "radiosity/closure.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstddef>
#include <numeric>
#include <stdexcept>
#include <vector>

#include "math/extremes.hpp"

namespace sr {
namespace {

void check_rows(const FormFactorMatrix& F) {
    for (std::size_t i = 0; i < F.size(); ++i)
        if (!(F.row_sum(i) > 0))
            throw std::invalid_argument(fmt::format(
                "patch {} sees nothing, and no factor makes its form factors add up to 1; close the scene",
                i));
}

}  // namespace

double closure_defect(const FormFactorMatrix& F) {
    double worst = 0;
    for (std::size_t i = 0; i < F.size(); ++i) worst = max_or_nan(worst, std::abs(F.row_sum(i) - 1));
    return worst;
}

FormFactorMatrix with_normalised_rows(FormFactorMatrix F) {
    check_rows(F);
    for (std::size_t i = 0; i < F.size(); ++i) {
        const double sum = F.row_sum(i);
        for (double& factor : F.row(i)) factor /= sum;
    }
    return F;
}

FormFactorMatrix symmetrically_scaled(FormFactorMatrix F, double tolerance) {
    check_rows(F);
    constexpr int       most_rounds = 1000;
    std::vector<double> d(F.size(), 1.0), sum(F.size());
    double              worst = 0;
    for (int round = 0; round < most_rounds; ++round) {
        worst = 0;
        for (std::size_t i = 0; i < F.size(); ++i) {
            const auto row = F.row(i);
            sum[i]         = d[i] * std::inner_product(row.begin(), row.end(), d.begin(), 0.0);
            worst          = max_or_nan(worst, std::abs(sum[i] - 1));
        }
        if (worst <= tolerance) break;
        // The root, because the correction comes once with d_i and once with all d_j.
        for (std::size_t i = 0; i < F.size(); ++i) d[i] /= std::sqrt(sum[i]);
    }
    if (!(worst <= tolerance))
        throw std::runtime_error(
            fmt::format("form factors can't be scaled symmetrically: rows are still off by {:.2g} after {} "
                        "rounds; is the scene "
                        "closed?",
                        worst, most_rounds));
    for (std::size_t i = 0; i < F.size(); ++i)
        for (std::size_t j = 0; j < F.size(); ++j) F(i, j) *= d[i] * d[j];
    return F;
}

}  // namespace sr
