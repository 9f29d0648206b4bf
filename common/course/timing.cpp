/// @file timing.cpp

#include "course/timing.hpp"

#include <algorithm>
#include <limits>

namespace sr::course {
namespace {

constexpr double warm_up = 0.1;  // [s]

}  // namespace

std::vector<Timing> measure(const std::vector<Work>& all, int repeats) {
    std::vector<Timing> timings;
    const auto          forget = [&] {
        timings.clear();
        for (const Work& work : all)
            timings.push_back({work.name, std::numeric_limits<double>::infinity(), 0});
    };
    const auto run_all = [&] {
        for (std::size_t i = 0; i < all.size(); ++i) {
            const double seconds = seconds_of(all[i].run);
            timings[i].seconds   = std::min(timings[i].seconds, seconds);
            timings[i].slowest   = std::max(timings[i].slowest, seconds);
        }
    };
    forget();
    int counted = 1;
    if (seconds_of(run_all) < warm_up) {
        forget();
        counted = 0;
    }
    for (; counted < repeats; ++counted) run_all();
    return timings;
}

}  // namespace sr::course
