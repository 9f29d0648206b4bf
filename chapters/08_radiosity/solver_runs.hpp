#pragma once
/// @file solver_runs.hpp
/// All solvers under one roof, to be compared.

#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "course/style.hpp"
#include "lit_room.hpp"
#include "radiosity/conjugate_gradients.hpp"
#include "radiosity/gauss_seidel.hpp"
#include "radiosity/progressive_shooting.hpp"
#include "radiosity/relaxed_jacobi.hpp"
#include "radiosity/southwell.hpp"

namespace sr {

/// A solver's colour, the same on all charts.
[[nodiscard]] inline course::Ink ink_of_solver(std::string_view solver) {
    using course::Ink;
    static const std::map<std::string_view, Ink> inks{
        {"direct", Ink::blue},      {"Jacobi", Ink::vermilion}, {"Gauss-Seidel", Ink::green},
        {"Southwell", Ink::purple}, {"shooting", Ink::amber},   {"conjugate gradients", Ink::black}};
    return inks.at(solver);
}

/// A solver in sweeps: as much work as one look at all of F.
struct SolverRun {
    std::string                            name;
    std::function<Radiosities(int sweeps)> after;  ///< so many, from the start

    std::function<int(const Radiosities& exact)> sweeps_to_a_millionth;  ///< of error
};

/// @param steps_of_sweep how many steps make a sweep
template <class Make>
[[nodiscard]] SolverRun solver_run(std::string name, const RadiositySystem& system,
                                   std::size_t steps_of_sweep, const Make& make) {
    const auto sweep = [=](auto& solver) {
        for (std::size_t i = 0; i < steps_of_sweep; ++i) solver.step();
    };
    const auto after = [=](int sweeps) {
        auto solver = make();
        for (int i = 0; i < sweeps; ++i) sweep(solver);
        return Radiosities(solver.radiosities());
    };
    const auto count = [=, &system](const Radiosities& exact) {
        auto solver = make();
        int  sweeps = 0;
        for (; relative_error(system, solver.radiosities(), exact) > 1e-6; ++sweeps) sweep(solver);
        return sweeps;
    };
    return {std::move(name), after, count};
}

/// @param system is referred to
[[nodiscard]] inline std::vector<SolverRun> solver_runs(const RadiositySystem& system) {
    const std::size_t n = system.size();
    return {solver_run("Jacobi", system, 1, [&] { return RelaxedJacobi(system); }),
            solver_run("Gauss-Seidel", system, 1, [&] { return GaussSeidel(system); }),
            solver_run("Southwell", system, n, [&] { return Southwell(system); }),
            solver_run("shooting", system, n, [&] { return ProgressiveShooting(system); }),
            solver_run("conjugate gradients", system, 1, [&] { return ConjugateGradients(system); })};
}

}  // namespace sr
