#pragma once
/// @file plates_chart.hpp
/// The chart of section 7.4: the error of what four plates let through, against the rays that were traced for it.

#include <cmath>
#include <string>

#include "course/chapter.hpp"
#include "plates.hpp"

namespace sr {

inline constexpr int plates_in_pile = 4;

[[nodiscard]] inline course::Axes plates_axes() {
    course::Axes axes{.x = "rays", .y = "error of the transmittance", .log = course::axis::xy};
    axes.columns   = course::speed_accuracy({"rays"});
    axes.columns.x = "rays";
    axes.columns.y = "error";
    return axes;
}

inline void chart_plates(course::Chart chart) {
    const double exact = transmittance(plates_in_pile, 0.04);
    const auto add = [&](const std::string& name, double effort, const RecursionOptions& options, int trees) {
        SeenThrough  seen;
        const double seconds =
            course::seconds_of([&] { seen = look_through_plates(plates_in_pile, options, trees); });
        // Of chance, the error that is expected: the one that came is as large by chance.
        const double error =
            trees > 1 ? seen.radiance.standard_error() : std::abs(seen.radiance.mean() - exact);
        chart.row({name, effort, seconds, error, 0, double(seen.rays)});
    };
    for (int depth = 1; depth <= 19; depth += 2) add("all branches", depth, {.depth = depth}, 1);
    for (const float share : {0.1F, 1e-2F, 1e-3F, 3e-4F, 3e-5F, 1e-5F, 1e-6F, 3e-7F, 1e-8F})
        add("cut off", double(share), {.depth = 1000, .cut_off = share}, 1);
    for (const int trees : {10, 100, 1000, 10'000})
        add("one branch at random", trees, {.depth = 1000, .branching = Branching::random}, trees);
}

}  // namespace sr
