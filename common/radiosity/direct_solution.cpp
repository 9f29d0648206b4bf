/// @file direct_solution.cpp

#include "radiosity/direct_solution.hpp"

#include <Eigen/LU>

namespace sr {
namespace {

using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

void solve_primary(const RadiositySystem& system, double DoubleSpectrum::*primary, Radiosities& result) {
    const auto      n = Eigen::Index(system.size());
    Eigen::VectorXd rho(n), emission(n);
    for (Eigen::Index i = 0; i < n; ++i) {
        rho(i)      = system.reflectance[std::size_t(i)].*primary;
        emission(i) = system.emission[std::size_t(i)].*primary;
    }
    const Eigen::Map<const RowMajor> F(system.form_factors.row(0).data(), n, n);
    const Eigen::MatrixXd            matrix   = Eigen::MatrixXd::Identity(n, n) - rho.asDiagonal() * F;
    const Eigen::VectorXd            solution = matrix.partialPivLu().solve(emission);
    for (Eigen::Index i = 0; i < n; ++i) result[std::size_t(i)].*primary = solution(i);
}

}  // namespace

Radiosities direct_solution(const RadiositySystem& system) {
    Radiosities result(system.size());
    for (const auto primary : {&DoubleSpectrum::r, &DoubleSpectrum::g, &DoubleSpectrum::b})
        solve_primary(system, primary, result);
    return result;
}

}  // namespace sr
