/// @file reciprocity.cpp

#include "radiosity/reciprocity.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace sr {
namespace {

struct Pair {
    std::size_t i = 0, j = 0;
    double      defect = 0;
};

Pair worst_pair(const FormFactorMatrix& form_factors, std::span<const double> area) {
    Pair worst;
    for (std::size_t i = 0; i < form_factors.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) {
            const double there = area[i] * form_factors(i, j), back = area[j] * form_factors(j, i);
            const double defect = std::abs(there - back) / std::min(area[i], area[j]);
            if (defect > worst.defect || std::isnan(defect)) worst = {i, j, defect};
        }
    }
    return worst;
}

}  // namespace

double reciprocity_defect(const FormFactorMatrix& form_factors, std::span<const double> area) {
    return worst_pair(form_factors, area).defect;
}

FormFactorMatrix symmetrised(const FormFactorMatrix& form_factors, std::span<const double> area) {
    FormFactorMatrix result = form_factors;
    for (std::size_t i = 0; i < result.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) {
            const double mean = (area[i] * form_factors(i, j) + area[j] * form_factors(j, i)) / 2;
            result(i, j)      = mean / area[i];
            result(j, i)      = mean / area[j];
        }
    }
    return result;
}

void check_reciprocity(const FormFactorMatrix& form_factors, std::span<const double> area, double tolerance) {
    const auto [i, j, defect] = worst_pair(form_factors, area);
    if (defect <= tolerance) return;
    throw std::invalid_argument(
        fmt::format("the form factors between patches {} and {} are {:.6g} and {:.6g} for areas {:.6g} and "
                    "{:.6g}, which is not reciprocal; make them symmetrised()",
                    i, j, form_factors(i, j), form_factors(j, i), area[i], area[j]));
}

}  // namespace sr
