/// @file timing.cpp

#include "course/timing.hpp"

#include <algorithm>

namespace sr::course {
namespace {

constexpr double warm_up = 0.1;  // [s]

}  // namespace

std::vector<Timing> measure(const std::vector<Work>& all, int repeats) {
    std::vector<std::vector<double>> seconds(all.size());
    const auto                       run_all = [&] {
        for (std::size_t i = 0; i < all.size(); ++i) seconds[i].push_back(seconds_of(all[i].run));
    };
    const double first = seconds_of(run_all);
    if (first < warm_up) {
        for (auto& of_one : seconds) of_one.clear();
    }
    while (seconds[0].size() < std::size_t(repeats)) run_all();

    std::vector<Timing> timings;
    for (std::size_t i = 0; i < all.size(); ++i) {
        std::vector<double>& sorted = seconds[i];
        std::sort(sorted.begin(), sorted.end());
        const double low  = sorted[(sorted.size() - 1) / 2];
        const double high = sorted[sorted.size() / 2];
        timings.push_back({all[i].name, (low + high) / 2, sorted.front(), sorted.back()});
    }
    return timings;
}

}  // namespace sr::course
