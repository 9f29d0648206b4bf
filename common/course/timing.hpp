#pragma once
/// @file timing.hpp
/// Wall-clock time of a piece of code, for charts and benchmarks; never for a test's verdict.

#include <chrono>
#include <functional>
#include <string>
#include <vector>

namespace sr::course {

/// The time that one call takes [s].
template <class F>
[[nodiscard]] double seconds_of(F&& work) {
    const auto start = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// A piece of work with a name: {"hierarchy", [&] { ... }}.
struct Work {
    std::string           name;
    std::function<void()> run;
};

/// Seconds for one run: the median of the repeats and their extremes.
struct Timing {
    std::string name;
    double      median = 0;
    double      min    = 0;
    double      max    = 0;
};

/// Runs all, then all again, `repeats` times, so that what else the machine does hits all of them alike.
/// Where all together take less than 0.1 s, they run once more before: the first run finds cold caches.
/// @pre repeats >= 1, all is not empty
[[nodiscard]] std::vector<Timing> measure(const std::vector<Work>& all, int repeats);

}  // namespace sr::course
