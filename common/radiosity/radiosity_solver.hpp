#pragma once
/// @file radiosity_solver.hpp
/// Iterative solvers of (I - rho F) B = E, and the loop that runs them. How to use:
///     check_system(system);
///     show(solution_by(RelaxedJacobi(system), 1e-6, 1000));
/// or, to see how it comes along:
///     RelaxedJacobi solver(system);
///     const Convergence told = solve(solver, 1e-6, 1000);
///     if (told.reached) show(solver.radiosities());

#include <fmt/format.h>

#include <concepts>
#include <cstddef>
#include <stdexcept>
#include <vector>

#include "radiosity/radiosity_system.hpp"

namespace sr {

/// A solver holds radiosities, 0 or the emission at first, and each step makes them better. It refers to its system,
/// which outlives it and has passed check_system. Its residual is the largest one over the largest emission [1].
template <class S>
concept RadiositySolver = requires(S solver, const S& done) {
    solver.step();
    { done.radiosities() } -> std::convertible_to<Radiosities>;
    { done.residual() } -> std::same_as<double>;
};

/// How a solver came along: its residual before the first step and after each.
struct Convergence {
    std::vector<double> residuals;
    bool                reached = false;  ///< the tolerance

    [[nodiscard]] std::size_t steps() const { return residuals.size() - 1; }
};

/// Steps until the residual is no more than the tolerance, at most `limit` of them, and none once it is NaN. The error
/// of the radiosities may be larger than their residual: up to 1 / (1 - rho) times in a room of one reflectance.
template <RadiositySolver S>
[[nodiscard]] Convergence solve(S& solver, double tolerance, int limit) {
    Convergence told{{solver.residual()}};
    for (int i = 0; i < limit && told.residuals.back() > tolerance; ++i) {
        solver.step();
        told.residuals.push_back(solver.residual());
    }
    told.reached = told.residuals.back() <= tolerance;
    return told;
}

/// The radiosities when the tolerance is reached [W/m^2].
/// @throws std::runtime_error with the residual and the number of steps if it is not
template <RadiositySolver S>
[[nodiscard]] Radiosities solution_by(S solver, double tolerance, int limit) {
    const Convergence told = solve(solver, tolerance, limit);
    if (!told.reached)
        throw std::runtime_error(
            fmt::format("the residual of the radiosities is {:.2g} after {} steps; must be {} at most: where "
                        "nearly all light is "
                        "reflected, allow more steps or a larger tolerance",
                        told.residuals.back(), told.steps(), tolerance));
    return solver.radiosities();
}

}  // namespace sr
