#pragma once
/// @file steps_that_miss.hpp
/// The chart of section 2.4: which share of a sphere, and of a wire, is thinner than a step.

#include <cmath>
#include <numeric>
#include <utility>
#include <vector>

#include "course/chapter.hpp"
#include "geometry/implicit_ellipsoid.hpp"
#include "geometry/implicit_marching.hpp"
#include "geometry/implicit_torus.hpp"
#include "loose_bounds.hpp"
#include "transport/tiles.hpp"

namespace sr {

/// The share [%] of rays that do meet a surface, but which a method misses: of so many that are spread evenly over
/// two numbers from 0 to 1, where they pass and at which phase their steps begin.
/// @param thousands  of rays
/// @param misses     (where, phase) -> bool
template <class Misses>
[[nodiscard]] double percent_missed(const course::Options& options, int thousands, const Misses& misses) {
    const int        rays   = 1000 * thousands;
    constexpr double golden = 0.6180339887498949;  // its multiples modulo 1 leave the least gaps
    std::vector<int> missed(std::size_t(rays), 0);
    for_each_pixel(1000, thousands, {.threads = options.threads}, [&](int x, int y) {
        const int    i         = 1000 * y + x;
        const double turns     = i * golden;
        missed[std::size_t(i)] = misses((i + 0.5) / rays, turns - std::floor(turns)) ? 1 : 0;
    });
    return 100.0 * std::accumulate(missed.begin(), missed.end(), 0) / rays;
}

/// Whether steps of this length miss the unit sphere on a chord; evenly spread points of a disk have uniform chords.
[[nodiscard]] inline bool misses_sphere(double where, double phase, double step) {
    const LooseBounds<Ellipsoid<double>, double> sphere{{{1, 1, 1}}, 4};
    return !march(sphere, {{-2.5, std::sqrt(where), 0}, {1, 0, 0}}, {phase * step, 5}, step);
}

/// Whether they miss a ring of wire at which the ray is aimed, through the middle of the wire and across it.
[[nodiscard]] inline bool misses_wire(double tube, double phase, double step) {
    const LooseBounds<Torus<double>, double> ring{{1, tube}, 4};
    return !march(ring, {{1, 0, -2.5}, {0, 0, 1}}, {phase * step, 5}, step);
}

/// What is missed against the step's length, and the laws s^2 / 12 and 1 - 2 r / s.
[[nodiscard]] inline course::Chart chart_steps_that_miss(course::Chapter& chapter) {
    auto chart =
        chapter.chart("steps_that_miss", "What lies between two steps is not seen",
                      {.x = "length $s$ of a step", .y = "true hits missed [%]", .log = course::axis::xy});
    const auto& options = chapter.options();
    for (const double step : {1.2, 0.022})  // beyond those that are counted
        chart.add("unit sphere, $s^2/12$", step, 100 * step * step / 12);
    for (const double step : {1.0, 0.5, 0.2, 0.1, 0.05, 0.025}) {
        chart.add("unit sphere, counted", step, percent_missed(options, 400, [&](double where, double phase) {
                      return misses_sphere(where, phase, step);
                  }));
        for (const auto& [name, tube] :
             {std::pair{"wire of radius 0.01", 0.01}, {"wire of radius 0.001", 0.001}}) {
            chart.add(name, step, percent_missed(options, 1, [&](double, double phase) {
                          return misses_wire(tube, phase, step);
                      }));
        }
    }
    chart.as_line("unit sphere, $s^2/12$");
    chart.as_points("unit sphere, counted");
    chart.caption(
        "Half the step, a quarter of the misses: true of a sphere, and of no help against what is thin "
        "everywhere. Rays and phases are evenly spread, not random.");
    return chart;
}

}  // namespace sr
