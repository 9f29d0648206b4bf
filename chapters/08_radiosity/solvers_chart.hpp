#pragma once
/// @file solvers_chart.hpp
/// Section 8.5: all solvers on one room, against time and against sweeps.

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "course/chapter.hpp"
#include "lit_room.hpp"
#include "radiosity/direct_solution.hpp"
#include "radiosity/relaxation.hpp"
#include "radiosity/residual.hpp"
#include "solver_runs.hpp"

namespace sr {

/// One room on a chart of error against time: each solver after 1, 2, 4, ... sweeps, timed on one thread. On a second
/// one residual and error of three of them.
class SolverRace {
public:
    SolverRace(course::Chart chart, course::Chart residuals, const RadiositySystem& room, int sweeps)
        : chart_(std::move(chart)),
          residuals_(std::move(residuals)),
          room_(room),
          sweeps_(sweeps),
          exact_(direct_solution(room)) {}

    void run(int repeats) {
        const auto                solvers = solver_runs(room_);
        std::vector<course::Work> works{{"direct", [&] { last_ = direct_solution(room_); }}};
        std::vector<Point>        points{{1, exact_}};
        course::Progress progress("timing the solvers", int(solvers.size()) * 2 * sweeps_ * (repeats + 1));
        for (const auto& solver : solvers) {
            double error = 1;
            for (int sweeps = 1; sweeps <= sweeps_ && error > rounding; sweeps *= 2) {
                works.push_back({solver.name, [&, sweeps] {
                                     last_ = solver.after(sweeps);
                                     progress.tick(sweeps);
                                 }});
                points.push_back({sweeps, solver.after(sweeps)});
                error = relative_error(room_, points.back().found, exact_);
            }
        }
        const auto times = course::measure(works, repeats);
        for (std::size_t i = 0; i < times.size(); ++i) {
            add(times[i], points[i]);
            const std::string& name = times[i].name;
            if (name == "Jacobi" || name == "Gauss-Seidel" || name == "conjugate gradients")
                add_residual(times[i], points[i].found);
        }
    }

private:
    struct Point {
        int         sweeps;
        Radiosities found;
    };

    /// Less is no error of the solver's any more: what all are held to has as much.
    static constexpr double rounding = 1e-13;

    void add(const course::Timing& time, const Point& point) {
        const double error    = std::max(rounding, relative_error(room_, point.found, exact_));
        const double residual = relative_size(residuals(room_, point.found, 1), room_.emission);
        chart_.row({time.name, point.sweeps, time.seconds, error, 0.0, residual, room_.reflectance[0].r});
        chart_.in_ink(time.name, ink_of_solver(time.name));
    }

    void add_residual(const course::Timing& time, const Radiosities& found) {
        const double error   = relative_error(room_, found, exact_);
        const double missing = relative_rms(room_, residuals(room_, found, 1), exact_);
        if (error < rounding) return;
        for (const auto& [what, value] : {std::pair{": error", error}, {": residual", missing}}) {
            residuals_.add(time.name + what, time.seconds, value);
            residuals_.in_ink(time.name + what, ink_of_solver(time.name));
        }
        residuals_.as_dashed(time.name + ": residual");
    }

    course::Chart          chart_, residuals_;
    const RadiositySystem& room_;
    int                    sweeps_;
    Radiosities            exact_, last_;
};

/// A dark, a middling and a bright room.
inline void chart_solvers(course::Chapter& chapter) {
    const bool            draft = chapter.options().quality == course::Quality::draft;
    const RadiositySystem room  = lit_room(draft ? 5 : 10, 0.9, chapter.options().threads);
    for (const auto& [name, rho] : {std::pair{"", 0.9}, {"_dark", 0.5}, {"_bright", 0.99}}) {
        const auto title    = fmt::format("A room of {} patches, reflectance {}", room.size(), rho);
        auto       chart    = chapter.chart(fmt::format("solvers{}", name), title,
                                            {.x       = "time on one core [s]",
                                             .y       = "relative error, root mean square",
                                             .log     = course::axis::xy,
                                             .columns = course::speed_accuracy({"residual", "reflectance"})});
        auto       residual = chapter.chart(
                  fmt::format("residuals_in_time{}", name), title,
                  {.x = "time on one core [s]", .y = "relative residual, relative error", .log = course::axis::xy});
        const auto grey_room = painted(room, rho);
        const int  most      = draft ? 64 : 256;
        SolverRace(chart, residual, grey_room, most).run(draft ? 1 : 3);
        chart.caption(fmt::format(
            "After 1, 2, 4, ... and at most {} sweeps, each as much work as one product with $F$. "
            "Errors below $10^{{-13}}$ are rounding, and drawn there.",
            most));
        residual.caption(
            "The same runs, down to rounding. Both in one measure: root mean square, as a share of the "
            "radiosity's.");
    }
}

/// The residual is what a solver knows, and the error is what one wants to know, both by relative_rms().
/// @param most  sweeps of Jacobi's method
/// @return      Jacobi's error over its residual, after the last of them
inline double chart_residuals(course::Chart& chart, const RadiositySystem& room, int most) {
    const auto exact = direct_solution(room);
    const auto runs  = solver_runs(room);
    for (const auto& [name, step, last] : {std::tuple{"Jacobi", most / 12, most},
                                           {"Gauss-Seidel", most / 12, most},
                                           {"conjugate gradients", 1, 12}}) {
        const std::string error = name + std::string(": error"), residual = name + std::string(": residual");
        const auto&       run = *std::find_if(runs.begin(), runs.end(),
                                              [&, n = name](const SolverRun& r) { return r.name == n; });
        for (int sweeps = step; sweeps <= last; sweeps += step) {
            const auto found = run.after(sweeps);
            chart.add(error, sweeps, relative_error(room, found, exact));
            chart.add(residual, sweeps, relative_rms(room, residuals(room, found, 1), exact));
        }
        for (const auto& curve : {error, residual}) chart.in_ink(curve, ink_of_solver(name));
        chart.as_dashed(residual);
    }
    return chart.at("Jacobi: error", most) / chart.at("Jacobi: residual", most);
}

/// Against sweeps, in the three rooms.
inline void chart_residuals(course::Chapter& chapter) {
    const auto room = lit_room(4, 0.5, chapter.options().threads);
    for (const auto& [name, rho, most, larger] : {std::tuple{"residuals", 0.99, 96, 100.0},
                                                  {"residuals_dark", 0.5, 24, 2.0},
                                                  {"residuals_middling", 0.9, 96, 10.0}}) {
        auto chart =
            chapter.chart(name, fmt::format("A room of {} patches, reflectance {}", room.size(), rho),
                          {.x = "sweeps", .y = "relative residual, relative error", .log = course::axis::y});
        const double ratio = chart_residuals(chart, painted(room, rho), most);
        chapter.claim(fmt::format("8.5 reflectance {}, Jacobi: error over residual in the end", rho),
                      {.expected = larger, .measured = ratio, .tolerance = larger / 2000});
        chart.caption("Residual and error in one measure: root mean square, as a share of the radiosity's.");
    }
}

/// How many sweeps each solver takes to an error of a millionth, on a room that is always the same.
inline void claim_sweeps(course::Chapter& chapter) {
    const auto                                             room = lit_room(4, 0.9, chapter.options().threads);
    course::Rows                                           table{{"reflectance", "solver", "sweeps"}};
    const std::vector<std::pair<double, std::vector<int>>> expected{{0.5, {19, 11, 10, 10, 6, 15}},
                                                                    {0.9, {131, 67, 66, 66, 9, 91}},
                                                                    {0.99, {1375, 689, 688, 688, 9, 937}}};
    for (const auto& [rho, sweeps] : expected) {
        const auto   grey_room = painted(room, rho);
        const auto   exact     = direct_solution(grey_room);
        const double lambda    = best_lambda(jacobi_eigenvalues(grey_room));
        auto         runs      = solver_runs(grey_room);
        runs.push_back(solver_run("Jacobi, best lambda", grey_room, 1,
                                  [&] { return RelaxedJacobi(grey_room, lambda); }));
        for (std::size_t k = 0; k < runs.size(); ++k) {
            const int measured = runs[k].sweeps_to_a_millionth(exact);
            table.add({rho, runs[k].name, measured});
            chapter.claim(
                fmt::format("8.5 {}, reflectance {}: sweeps to an error of a millionth", runs[k].name, rho),
                {.expected = double(sweeps[k]), .measured = double(measured), .tolerance = 0.5});
        }
    }
    chapter.say(table);
}

}  // namespace sr
