#pragma once
/// @file steps_to_a_millionth.hpp

#include "lit_room.hpp"
#include "radiosity/direct_solution.hpp"

namespace sr {

/// The steps until the error is a millionth of what it was at first, when B was 0.
/// @pre the solver converges
template <class Solver>
[[nodiscard]] int steps_to_a_millionth(const RadiositySystem& system, Solver solver) {
    const auto exact = direct_solution(system);
    int        steps = 0;
    for (; !(relative_error(system, solver.radiosities(), exact) <= 1e-6); ++steps) solver.step();
    return steps;
}

}  // namespace sr
