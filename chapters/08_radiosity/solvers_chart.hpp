#pragma once
/// @file solvers_chart.hpp
/// Section 8.5: all solvers on one room, against time and against sweeps.

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <functional>
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
        const auto solvers = solver_runs(room_);
        try_out({"direct", 1, [&] { return direct_solution(room_); }});
        try_out_all(solvers);
        time(repeats);
        for (const Point& point : points_) {
            add(point);
            if (point.solver == "Jacobi" || point.solver == "Gauss-Seidel" ||
                point.solver == "conjugate gradients")
                add_residual(point);
        }
    }

private:
    struct Point {
        std::string                  solver;
        int                          sweeps;
        std::function<Radiosities()> run;
        Radiosities                  found   = {};
        double                       seconds = 0;
    };

    void try_out(Point point) {
        point.seconds = course::seconds_of([&] { point.found = point.run(); });
        points_.push_back(std::move(point));
    }

    /// Each solver until it has done all sweeps, or nothing is left of its error. All in turn: their sweeps take longer
    /// or shorter.
    void try_out_all(const std::vector<SolverRun>& solvers) {
        course::Progress    progress("solving", int(solvers.size()) * (2 * sweeps_ - 1));
        std::vector<double> errors(solvers.size(), 1);
        for (int sweeps = 1; sweeps <= sweeps_; sweeps *= 2)
            for (std::size_t k = 0; k < solvers.size(); ++k) {
                if (errors[k] > rounding) {
                    const auto& solver = solvers[k];
                    try_out({solver.name, sweeps, [&solver, sweeps] { return solver.after(sweeps); }});
                    errors[k] = relative_error(room_, points_.back().found, exact_);
                }
                progress.tick(sweeps);
            }
    }

    /// How long all will take is known from the first runs.
    void time(int repeats) {
        const auto milliseconds = [](const Point& point) { return 1 + int(1000 * point.seconds); };
        int        all          = 0;
        for (const Point& point : points_) all += milliseconds(point);
        course::Progress          progress("timing the solvers", all * repeats);
        std::vector<course::Work> works;
        for (const Point& point : points_)
            works.push_back({point.solver, [&] {
                                 last_ = point.run();
                                 progress.tick(milliseconds(point));
                             }});
        const auto times = course::measure(works, repeats);
        for (std::size_t i = 0; i < times.size(); ++i) points_[i].seconds = times[i].seconds;
    }

    /// Less is no error of the solver's any more: what all are held to has as much.
    static constexpr double rounding = 1e-13;

    void add(const Point& point) {
        const double error    = std::max(rounding, relative_error(room_, point.found, exact_));
        const double residual = relative_size(residuals(room_, point.found, 1), room_.emission);
        chart_.row({point.solver, point.sweeps, point.seconds, error, 0.0, residual, room_.reflectance[0].r});
        chart_.in_ink(point.solver, ink_of_solver(point.solver));
    }

    void add_residual(const Point& point) {
        const double error   = relative_error(room_, point.found, exact_);
        const double missing = relative_rms(room_, residuals(room_, point.found, 1), exact_);
        if (error < rounding) return;
        for (const auto& [what, value] : {std::pair{": error", error}, {": residual", missing}}) {
            residuals_.add(point.solver + what, point.seconds, value);
            residuals_.in_ink(point.solver + what, ink_of_solver(point.solver));
        }
        residuals_.as_dashed(point.solver + ": residual");
    }

    course::Chart          chart_, residuals_;
    const RadiositySystem& room_;
    int                    sweeps_;
    Radiosities            exact_, last_;
    std::vector<Point>     points_;
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
