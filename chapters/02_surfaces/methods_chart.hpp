#pragma once
/// @file methods_chart.hpp
/// The charts of section 2.5: what each method gets wrong, and how well it knows t, against its time for a ray.

#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "course/chapter.hpp"
#include "methods.hpp"

namespace sr {

/// One method at one effort, raced.
struct Lap {
    Method method;
    Score  score;
    double seconds;  ///< for a ray
};

/// Scores all methods on all rays, and times them, one after the other and repeatedly, on the first of them.
[[nodiscard]] inline std::vector<Lap> run_race(const Race& race, const std::vector<Method>& methods,
                                               course::Quality quality) {
    const bool                draft = quality == course::Quality::draft;
    const std::size_t         timed = draft ? 256 : 4096;
    int                       hits  = 0;  // looked at below: work whose result nobody needs is optimised away
    std::vector<course::Work> work;
    for (const auto& method : methods)
        work.push_back({method.name, [&] {
                            for (std::size_t i = 0; i < timed; ++i)
                                hits += method.first_root(race.rays()[i]) ? 1 : 0;
                        }});
    const auto       timings = course::measure(work, draft ? 1 : 5);
    std::vector<Lap> laps;
    for (std::size_t i = 0; i < methods.size(); ++i)
        laps.push_back({methods[i], race.score(methods[i]), timings[i].seconds / double(timed)});
    if (hits == 0) throw std::logic_error("no ray of the race hits its surface");
    return laps;
}

/// Axes of a chart of the laps; `column` is what is drawn, and `column`_se its standard error.
[[nodiscard]] inline course::Axes lap_axes(const std::string& column, const std::string& y) {
    course::Axes axes{.x = "time for a ray, one thread [ns]", .y = y, .log = course::axis::xy};
    axes.columns = course::speed_accuracy(
        {"missed", "invented", "t_error", "t_error_se", "ns_per_ray", "percent_wrong", "percent_wrong_se"});
    axes.columns.x     = "ns_per_ray";
    axes.columns.y     = column;
    axes.columns.error = column + "_se";
    return axes;
}

/// A chart of the laps: what is wrong, or t.
inline void chart_laps(course::Chart chart, const std::vector<Lap>& laps) {
    for (const auto& [method, score, seconds] : laps)
        chart.row({method.name, method.effort, seconds, score.wrong.value, score.wrong.error, score.missed,
                   score.invented, score.t_error.value, score.t_error.error, 1e9 * seconds,
                   percent(score.wrong).value, percent(score.wrong).error});
}

/// The lap of a method at an effort.
[[nodiscard]] inline const Lap& lap_of(const std::vector<Lap>& laps, const std::string& name, double effort) {
    for (const auto& lap : laps) {
        if (lap.method.name == name && std::abs(lap.method.effort - effort) <= 1e-6 * effort) return lap;
    }
    throw std::out_of_range("no lap of " + name);
}

}  // namespace sr
