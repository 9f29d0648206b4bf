/// @file radiosity.cpp
/// The Cornell box by radiosity on one thread: seconds, memory and error of all pairs of patches, and hierarchically.
///
/// `error` is the relative RMS error of what is reflected, at 4000 points. `all_pairs_s` is how long all pairs would
/// take to that error, by the power laws of their own runs, and `faster` how many times that is. `mebibytes` is what
/// the data hold. The last rows are the powers of n.

#include <cmath>
#include <span>
#include <string>
#include <vector>

#include "../../chapters/08_radiosity/scaling_chart.hpp"
#include "course/bench.hpp"
#include "course/progress.hpp"

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

course::Rows rows() {
    const CornellMeshes       box;
    const std::vector<double> bounds{0.016, 0.0037, 0.00096, 0.00018}, sizes{62, 40, 32.2, 26.2};
    course::Progress          progress("solving", int(bounds.size() + sizes.size()) + 1);
    const auto                reference = box.gathered(box.solution(0.0003, 0), 0);
    progress.tick();
    std::vector<MeshCost> costs;
    const auto            add = [&](const MeshCost& cost) {
        costs.push_back(cost);
        progress.tick();
    };
    for (const double bound : bounds) add(hierarchical_cost(box, bound, reference));
    for (const double size : sizes) add(dense_cost(box, size, reference));

    course::Rows table{{"method", "n", "seconds", "mebibytes", "error", "all_pairs_s", "faster"}};
    for (std::size_t i = 0; i < costs.size(); ++i) {
        const auto& [method, n, seconds, mebibytes, error] = costs[i];
        const double all_pairs                             = all_pairs_seconds(costs, error);
        table.add({method, n, seconds, mebibytes, error, all_pairs, all_pairs / seconds});
    }
    for (const std::string method : {"hierarchical", "all pairs"}) {
        const auto  power = [&](double MeshCost::*column) { return exponent(costs, method, column); };
        const Slope s = power(&MeshCost::seconds), m = power(&MeshCost::mebibytes),
                    e = power(&MeshCost::error);
        table.add({method + ": power of n", "", s.value, m.value, e.value, "", ""});
        table.add({method + ": its standard error", "", s.standard_error, m.standard_error, e.standard_error,
                   "", ""});
    }
    return table;
}

}  // namespace
}  // namespace sr

int main(int argc, char** argv) {
    return sr::course::run_benchmark(
        argc, argv,
        "The Cornell box by radiosity, one thread: seconds, memory and error of all "
        "pairs of patches, and hierarchically.",
        [] { return sr::rows(); });
}
