#pragma once
/// @file convergence_charts.hpp
/// Section 9.7: errors of patterns against samples, and against time.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "convergence.hpp"
#include "course/chapter.hpp"
#include "course/claims.hpp"

namespace sr {

/// An error that is a power of 1/n, and its name in TeX.
struct Law {
    std::string name;
    double      power;
};

/// One integrand's two charts: the same rows, drawn against samples and against time.
struct ConvergenceCharts {
    course::Chart    samples, time;
    std::vector<Law> laws;  ///< drawn beside the errors, against samples

    ConvergenceCharts(course::Chapter& chapter, const std::string& suffix, const std::string& of,
                      std::vector<Law> beside)
        : samples{chapter.chart("convergence" + suffix, "Error against samples: " + of,
                                axes("samples $n$", "effort"))},
          time{chapter.chart("convergence_time" + suffix, "Error against time: " + of,
                             axes("time for an estimate, one thread [$\\mu$s]", "microseconds"))},
          laws{std::move(beside)} {}

    static course::Axes axes(const std::string& x, const std::string& column) {
        auto columns = course::speed_accuracy({"microseconds"});
        columns.x    = column;
        return {.x = x, .y = "RMS error", .log = course::axis::xy, .columns = columns};
    }
};

/// Lines of the laws, from the first error of random samples down.
inline void add_laws(course::Chart chart, const std::vector<Law>& laws, const std::vector<PatternLap>& laps) {
    const auto [first, last] = std::ranges::minmax(laps, {}, &PatternLap::n);
    for (const auto& [name, power] : laws) {
        for (const double n : {double(first.n), double(last.n)})
            chart.row({name, n, 0.0, laps.front().error.value * std::pow(n / first.n, -power), 0.0, 0.0});
        chart.as_line(name);
        chart.as_dashed(name);
        chart.in_ink(name, course::Ink::grey);
    }
}

/// Times all laps, and charts them.
inline void chart_convergence(ConvergenceCharts charts, const std::vector<PatternLap>& laps,
                              course::Quality quality) {
    double                    sum = 0;  // looked at below: work whose result nobody needs is optimised away
    std::vector<course::Work> work;
    std::vector<int>          times;  // as many as give the clock something to measure
    for (const auto& lap : laps) {
        times.push_back(lap.n < 4096 ? int(4096 / lap.n) : 1);
        work.push_back({lap.method, [&sum, &lap, count = times.back()] {
                            for (int i = 0; i < count; ++i) sum += lap.once(std::uint64_t(i));
                        }});
    }
    const auto timings = course::measure(work, quality == course::Quality::draft ? 3 : 15);
    if (!(sum > 0)) throw std::logic_error("all means are 0");
    for (std::size_t i = 0; i < laps.size(); ++i) {
        const double seconds = timings[i].seconds / times[i];
        for (auto* chart : {&charts.samples, &charts.time})
            chart->row({laps[i].method, double(laps[i].n), seconds, laps[i].error.value, laps[i].error.error,
                        1e6 * seconds});
    }
    add_laws(charts.samples, charts.laws, laps);
    charts.samples.caption(
        "RMS error over 256 seeds, with standard errors. Halving it takes 4 times as many random samples.");
    charts.time.caption(
        "The same errors. The time is that of making the points and of adding up the function.");
}

/// The power of 1/n that an error is, with its standard error, as the text prints them; `law` is what theory says, 0
/// where there is none.
struct PrintedPower {
    std::string method;
    double      power, error, law;
    double      samples_to_halve;  ///< 2^(1/power)
};

inline void claim_powers(course::Chapter& chapter, const std::string& of, const std::vector<PatternLap>& laps,
                         const std::vector<PrintedPower>& printed) {
    const course::Claims claim{chapter, "9.7"};
    course::Rows rows{{"integrand", "points", "power", "standard error", "samples to halve the error"}};
    for (const auto& [method, power, error, law, to_halve] : printed) {
        const Slope  measured = slope_of(laps, method);
        const double factor   = std::exp2(-1 / measured.value);
        rows.add({of, method, -measured.value, measured.standard_error, factor});
        const std::string what = fmt::format("{}, {}: ", of, method);
        claim(what + "power by which the error falls", power, -measured.value, 0.0005);
        claim(what + "its standard error", error, measured.standard_error, 0.0005);
        claim(what + "times as many samples to halve the error", to_halve, factor, 0.05);
        if (law != 0)
            chapter.claim_at_most(fmt::format("9.7 {}power less {} [standard errors]", what, law),
                                  std::abs(measured.value + law) / measured.standard_error, 3);
    }
    chapter.say(rows);
}

/// What section 9.7 says of both integrands.
inline void claim_convergence(course::Chapter& chapter, const std::vector<PatternLap>& smooth,
                              const std::vector<PatternLap>& edge) {
    claim_powers(chapter, "smooth", smooth,
                 {{"random", 0.504, 0.006, 0.5, 4.0},
                  {"jittered", 0.988, 0.007, 1, 2.0},
                  {"Halton, moved", 0.894, 0.006, 0, 2.2},
                  {"Sobol', scrambled", 1.460, 0.006, 0, 1.6}});
    claim_powers(chapter, "edge", edge,
                 {{"random", 0.491, 0.006, 0.5, 4.1},
                  {"jittered", 0.752, 0.007, 0.75, 2.5},
                  {"Halton, moved", 0.732, 0.006, 0, 2.6},
                  {"Sobol', scrambled", 0.760, 0.006, 0.75, 2.5}});
    const course::Claims claim{chapter, "9.7"};
    const auto           gain = [&](const std::string& of, const std::vector<PatternLap>& laps,
                          const std::string& method, double printed, double error, double digit) {
        const Estimate coarse = error_of(laps, method, 1024), fine = error_of(laps, method, 4096);
        const double   ratio = coarse.value / fine.value;
        const double   se = ratio * std::hypot(coarse.error / coarse.value, fine.error / fine.value);
        claim(of + ", " + method + ": error with 1024 over that with 4096", printed, ratio, digit / 2);
        claim(of + ", " + method + ": its standard error", error, se, digit / 2);
    };
    gain("smooth", smooth, "random", 2.0, 0.1, 0.1);
    gain("smooth", smooth, "Sobol', scrambled", 8.5, 0.6, 0.1);
    gain("edge", edge, "Sobol', scrambled", 2.8, 0.2, 0.1);
}

}  // namespace sr
