/// @file radiosity.cpp
/// Radiosity on one thread: form factors, solvers, and the Cornell box by all pairs and hierarchically.
///
/// - `what`: two unit squares, whose form factor is computed; a room of 600 patches, of which that is known and light
///   is sought; or the Cornell box, of which both are.
/// - `method`: of form factors, of solving, or all pairs of patches against hierarchically.
/// - `n`: of squares the effort (points, pairs, rays, pixels, or one over the tolerance), the least that is wrong by at
///   most 1 %, or where none is that which is least wrong; of rooms the sweeps to an error of a millionth, each as
///   much work as one product with the form factors; of the box its patches or leaves.
/// - `seconds`: for one form factor; for all sweeps; for form factors, links and solution of the box.
/// - `mebibytes`: what the form factors or the links, trees and radiosities hold.
/// - `error`: relative. Of methods by chance, the root of the mean square over 32 repeats; of rooms, the root of the
///   mean square by area; of the box, the same of what is reflected at 4000 points.
/// - `all_pairs_s`: seconds that all pairs of the box would take to that error, by the power laws of their own runs.
/// - `faster`: how many times `seconds` that is.
///
/// Expect all pairs to grow with the square of n and the hierarchy with little more than n, seconds and memory alike;
/// and conjugate gradients to need ten sweeps where all others need the more of them the brighter the room is.
///
/// It takes about five minutes.

#include <fmt/format.h>

#include <cmath>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "../../chapters/08_radiosity/factor_charts.hpp"
#include "../../chapters/08_radiosity/scaling_chart.hpp"
#include "../../chapters/08_radiosity/solver_runs.hpp"
#include "course/bench.hpp"
#include "course/progress.hpp"
#include "course/timing.hpp"
#include "radiosity/direct_solution.hpp"

namespace sr {
namespace {

/// y of a power law through points, at x.
double power_law(std::span<const double> x, std::span<const double> y, double at) {
    const double slope = log_log_slope(x, y).value;
    double       sum   = 0;
    for (std::size_t i = 0; i < x.size(); ++i) sum += std::log(y[i]) - slope * std::log(x[i]);
    return std::exp(sum / double(x.size()) + slope * std::log(at));
}

/// How long all pairs take to an error.
double all_pairs_seconds(const std::vector<MeshCost>& costs, double error) {
    std::vector<double> errors, seconds;
    for (const auto& cost : costs) {
        if (cost.method != "all pairs") continue;
        errors.push_back(cost.error);
        seconds.push_back(cost.seconds);
    }
    return power_law(errors, seconds, error);
}

/// The Cornell box by both methods, and the powers of n.
void add_box(course::Rows& table) {
    const CornellMeshes box;
    const auto          reference = box.gathered(box.solution(0.0003, 0), 0);
    const auto          costs     = mesh_costs(
                     box, reference, {.sizes = {62, 40, 32.2, 26.2}, .bounds = {0.016, 0.0037, 0.00096, 0.00018}});
    for (const auto& [method, n, seconds, mebibytes, error] : costs) {
        const double all_pairs = all_pairs_seconds(costs, error);
        table.add({"Cornell box", method, n, seconds, mebibytes, error, all_pairs, all_pairs / seconds});
    }
    for (const std::string method : {"all pairs", "hierarchical"}) {
        const auto  power = [&](double MeshCost::*column) { return exponent(costs, method, column); };
        const Slope s = power(&MeshCost::seconds), m = power(&MeshCost::mebibytes),
                    e = power(&MeshCost::error);
        table.add({"its power of n", method, "", s.value, m.value, e.value, "", ""});
        table.add(
            {"its standard error", method, "", s.standard_error, m.standard_error, e.standard_error, "", ""});
    }
}

/// Of each method the least effort that is wrong by at most 1 %, or, if there is none, the least wrong.
void add_form_factors(course::Rows& table) {
    const auto       pairs = known_pairs();
    course::Progress progress("computing form factors", int(pairs.size()));
    for (const KnownPair& pair : pairs) {
        const FactorRace                         race(pair, 5);
        std::map<std::string, FactorRace::Point> best;
        for (const auto& point : race.points()) {
            auto& so_far = best.try_emplace(point.method, point).first->second;
            if (so_far.error.value > 0.01 && point.error.value < so_far.error.value) so_far = point;
        }
        for (const auto& [method, p] : best)
            table.add({"squares, " + pair.name, method, p.effort, p.seconds, "", p.error.value, "", ""});
        progress.tick();
    }
}

/// As many sweeps of each solver as it takes to an error of a millionth.
void add_solvers(course::Rows& table) {
    const RadiositySystem room = lit_room(10, 0.9, 0);
    course::Progress      progress("solving rooms", 5 * (2 + 10 + 100));
    for (const double rho : {0.5, 0.9, 0.99}) {
        const auto grey_room = painted(room, rho);
        const auto exact     = direct_solution(grey_room);
        for (const SolverRun& run : solver_runs(grey_room)) {
            const int    sweeps = run.sweeps_to_a_millionth(exact);
            Radiosities  found;
            const double seconds = course::seconds_of([&] { found = run.after(sweeps); });
            table.add({fmt::format("room, reflectance {}", rho), run.name, sweeps, seconds, "",
                       relative_error(grey_room, found, exact), "", ""});
            progress.tick(int(std::lround(1 / (1 - rho))));  // most take about so many times ten sweeps
        }
    }
}

course::Rows rows() {
    course::Rows table{{"what", "method", "n", "seconds", "mebibytes", "error", "all_pairs_s", "faster"}};
    add_form_factors(table);
    add_solvers(table);
    add_box(table);
    return table;
}

}  // namespace
}  // namespace sr

int main(int argc, char** argv) {
    return sr::course::run_benchmark(
        argc, argv,
        "Radiosity on one thread: form factors, solvers, and the Cornell box by all pairs and "
        "hierarchically; `course bench radiosity --help` tells what the columns are.",
        [] { return sr::rows(); });
}
