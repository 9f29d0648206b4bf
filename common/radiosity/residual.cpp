/// @file residual.cpp

#include "radiosity/residual.hpp"

#include <cmath>

#include "math/extremes.hpp"
#include "radiosity/rows.hpp"

namespace sr {
namespace {

/// The largest |value| of each primary, and NaN where one of them is.
DoubleSpectrum magnitude(const Radiosities& values) {
    DoubleSpectrum most;
    for (const auto& [r, g, b] : values)
        most = {max_or_nan(most.r, std::abs(r)), max_or_nan(most.g, std::abs(g)),
                max_or_nan(most.b, std::abs(b))};
    return most;
}

double share(double part, double whole) {
    return part == 0 && whole == 0 ? 0 : part / whole;
}

}  // namespace

DoubleSpectrum irradiance(const FormFactorMatrix& form_factors, const Radiosities& radiosities,
                          std::size_t i) {
    const auto     row = form_factors.row(i);
    DoubleSpectrum sum;
    for (std::size_t j = 0; j < row.size(); ++j) sum = sum + row[j] * radiosities[j];
    return sum;
}

Radiosities applied(const RadiositySystem& system, const Radiosities& radiosities, int threads) {
    Radiosities result(system.size());
    for_each_row(system.size(), {threads}, [&](std::size_t i) {
        result[i] = radiosities[i] - system.reflectance[i] * irradiance(system.form_factors, radiosities, i);
    });
    return result;
}

Radiosities residuals(const RadiositySystem& system, const Radiosities& radiosities, int threads) {
    Radiosities result = applied(system, radiosities, threads);
    for (std::size_t i = 0; i < result.size(); ++i) result[i] = system.emission[i] - result[i];
    return result;
}

double relative_size(const Radiosities& values, const Radiosities& whole) {
    const DoubleSpectrum part = magnitude(values), all = magnitude(whole);
    return largest(DoubleSpectrum{share(part.r, all.r), share(part.g, all.g), share(part.b, all.b)});
}

}  // namespace sr
