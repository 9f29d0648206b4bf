#pragma once
/// @file bright_rooms.hpp
/// Section 8.5: what becomes of the solvers where nearly all light is reflected.

#include <fmt/format.h>

#include <cmath>
#include <string>
#include <tuple>

#include "course/chapter.hpp"
#include "furnace.hpp"
#include "relaxation_charts.hpp"
#include "solver_runs.hpp"

namespace sr {

/// Sweeps against what is absorbed.
inline void chart_towards_one(course::Chapter& chapter) {
    auto chart =
        chapter.chart("towards_one", "A cube of 24 patches: sweeps to a millionth of the error",
                      {.x = "what is absorbed, $1 - \\rho$", .y = "sweeps", .log = course::axis::xy});
    const auto        room       = lit_room(2, 0.5, chapter.options().threads);
    const std::string lit_evenly = "$13.8 / (-\\ln\\rho)$";
    for (int i = 1; i <= 16; ++i) {
        const double absorbed  = std::pow(10.0, -i / 4.0);
        const auto   grey_room = painted(room, 1 - absorbed);
        const auto   exact     = direct_solution(grey_room);
        for (const auto& run : solver_runs(grey_room))
            if (run.name != "Southwell") {
                chart.add(run.name, absorbed, run.sweeps_to_a_millionth(exact));
                chart.in_ink(run.name, ink_of_solver(run.name));
            }
        chart.add(lit_evenly, absorbed, 13.8 / -std::log1p(-absorbed));
    }
    chart.as_line(lit_evenly);
    chart.in_ink(lit_evenly, course::Ink::grey);
    chart.caption("Ten times less is absorbed, and all but one of the solvers take ten times as long.");
}

/// The same in a room that is lit evenly, where 1 - rho is the only eigenvalue that is ever met.
inline void claim_steps_towards_one(course::Chapter& chapter) {
    for (const auto& [rho, steps] :
         {std::tuple{0.5, 20}, {0.9, 132}, {0.99, 1375}, {0.999, 13809}, {0.9999, 138149}}) {
        const auto   even     = cube_of_faces(std::vector<GreyPatch>(6, {rho, 1}));
        const double measured = steps_to_a_millionth(even, RelaxedJacobi(even));
        chapter.claim(fmt::format("8.5 a room that is lit evenly, reflectance {}: steps of Jacobi", rho),
                      {.expected = double(steps), .measured = measured, .tolerance = 0.5});
        if (rho > 0.999)
            chapter.claim("8.5 steps of Jacobi times what is absorbed",
                          {.expected = 13.8, .measured = measured * (1 - rho), .tolerance = 0.05});
    }
}

/// Where the iteration B = 1 + rho B stops.
inline void chart_stagnation(course::Chapter& chapter) {
    auto chart =
        chapter.chart("stagnation", "Where $B = 1 + \\rho B$ stops",
                      {.x = "what is absorbed, $1 - \\rho$", .y = "relative error", .log = course::axis::xy});
    for (int i = 2; i <= 20; ++i) {
        const double rho   = 1 - std::pow(10.0, -i / 4.0);
        const auto   error = [](double found, double reflectance) {
            return std::max(1e-16, std::abs(found * (1 - reflectance) - 1));
        };
        chart.add("float", 1 - rho, error(double(furnace(float(rho)).radiosity), double(float(rho))));
        chart.add("float, corrected", 1 - rho,
                  error(refined_furnace(float(rho)).radiosity, double(float(rho))));
        if (i <= 16) chart.add("double", 1 - rho, error(furnace(rho).radiosity, rho));
    }
    chart.caption(
        "Each is compared with the exact solution for the reflectance as its type rounds it. Of double, what "
        "takes millions of steps is left out.");
}

/// The same in numbers, with the solution for the reflectance that a float can hold.
inline void claim_stagnation(course::Chapter& chapter) {
    struct Row {
        float  rho;
        double stops, digit;
        int    steps;
        double exact;
    };
    for (const auto& [rho, stops, digit, steps, exact] : {Row{0.99F, 99.99972, 1e-5, 1230, 100.0001},
                                                          {0.999F, 999.9824, 1e-4, 10277, 1000.013},
                                                          {0.9999F, 9993.459, 1e-3, 75071, 9998.341},
                                                          {0.99999F, 99474.29, 1e-2, 542182, 99864.38}}) {
        const auto        stopped = furnace(rho);
        const std::string what    = fmt::format("8.5 in float, reflectance {}: ", rho);
        chapter.claim(what + "stops at",
                      {.expected = stops, .measured = double(stopped.radiosity), .tolerance = digit / 2});
        chapter.claim(what + "after steps",
                      {.expected = double(steps), .measured = double(stopped.steps), .tolerance = 0.5});
        chapter.claim(what + "and should be",
                      {.expected = exact, .measured = 1 / (1 - double(rho)), .tolerance = 5 * digit});
        chapter.claim_at_most(what + "error when it is corrected",
                              std::abs(refined_furnace(rho).radiosity * (1 - double(rho)) - 1), 1e-12);
    }
}

/// What the ambient term does for the first pictures.
inline void chart_ambient(course::Chapter& chapter) {
    constexpr double rho   = 0.8;
    auto             chart = chapter.chart(
                    "ambient", "Progressive shooting in a room of 150 patches",
                    {.x = "patches that have shot", .y = "relative error, root mean square", .log = course::axis::xy});
    const auto          room  = lit_room(5, rho, chapter.options().threads);
    const auto          exact = direct_solution(room);
    ProgressiveShooting shooting(room);
    for (int shots = 0, next = 1; shots <= 1500; ++shots, shooting.step()) {
        if (shots != next) continue;
        next = std::max(shots + 1, int(1.2 * shots));
        chart.add("as it is", shots, relative_error(room, shooting.radiosities(), exact));
        chart.add("with the ambient term", shots,
                  relative_error(room, shooting.radiosities_with_ambient(), exact));
    }
    chart.caption("Of reflectance 0.8. The nine patches of the lamp shoot first.");
}

}  // namespace sr
