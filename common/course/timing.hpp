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

/// Seconds for one run. All repeats do the same work, and what else the machine does can only add to their times: the
/// fastest is the one disturbed least, and estimates the work itself. A median would still hold what disturbs most of
/// them, so that on a busy machine more work may seem to take less time.
/// @see   Chen and Revels, Robust benchmarking in noisy environments (2016), which finds the same
struct Timing {
    std::string name;
    double      seconds = 0;  ///< of the fastest repeat
    double      slowest = 0;
};

/// Runs all, then all again, `repeats` times, so that what else the machine does hits all of them alike.
/// Where all together take less than 0.1 s, they run once more before: the first run finds cold caches.
/// @pre repeats >= 1, all is not empty
[[nodiscard]] std::vector<Timing> measure(const std::vector<Work>& all, int repeats);

}  // namespace sr::course
