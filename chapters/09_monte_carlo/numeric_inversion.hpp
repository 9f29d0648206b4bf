#pragma once
/// @file numeric_inversion.hpp
/// What it costs to look for x where P^-1 has no formula.

#include <cmath>
#include <functional>
#include <numbers>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "course/timing.hpp"
#include "inversion_diagram.hpp"
#include "math/extremes.hpp"
#include "sampling/inversion.hpp"
#include "statistics/running.hpp"

namespace sr {

/// A cumulative density on [0, last], and its inverse if there is a formula.
struct Invertible {
    std::string                                  name;
    double                                       last;
    std::function<double(double)>                P;
    std::optional<std::function<double(double)>> formula;
};

[[nodiscard]] inline std::vector<Invertible> invertible() {
    constexpr double pi = std::numbers::pi;
    return {
        {"sin(x) / 2", pi, [](double x) { return (1 - std::cos(x)) / 2; }, angle_to_pole},
        {"21 cos^20(x) sin(x)", pi / 2, [](double x) { return 1 - std::pow(std::cos(x), 21); },
         [](double u) { return std::acos(std::pow(1 - u, 1 / 21.0)); }},
        {"2 sin^2(x) / pi", pi, [](double x) { return (x - std::sin(x) * std::cos(x)) / pi; }, std::nullopt}};
}

constexpr int inversions = 10'000;

/// How often P is asked for one number, on average of equally distant ones.
[[nodiscard]] inline double evaluations(const Invertible& one) {
    Running mean;
    for (int i = 0; i < inversions; ++i)
        mean.add(
            invert_cdf(one.P, Interval<double>{0, one.last}, (i + 0.5) / inversions).value().evaluations);
    return mean.mean();
}

/// The largest difference between what is found and what the formula says.
[[nodiscard]] inline double inversion_error(const Invertible& one) {
    double worst = 0;
    for (int i = 0; i < inversions; ++i) {
        const double u = (i + 0.5) / inversions;
        worst = max_or_nan(worst, std::abs(invert_cdf(one.P, Interval<double>{0, one.last}, u).value().x -
                                           one.formula.value()(u)));
    }
    return worst;
}

/// How many times as long as the formula it takes to look.
[[nodiscard]] inline double slower_than_formula(const Invertible& one) {
    double     sum   = 0;  // looked at below: work whose result nobody needs is optimised away
    const auto times = course::measure(
        {{"formula",
          [&] {
              for (int i = 0; i < inversions; ++i) sum += (*one.formula)((i + 0.5) / inversions);
          }},
         {"search",
          [&] {
              for (int i = 0; i < inversions; ++i)
                  sum += invert_cdf(one.P, Interval<double>{0, one.last}, (i + 0.5) / inversions).value().x;
          }}},
        3);
    if (!(sum > 0)) throw std::logic_error("all numbers are 0");
    return times[1].seconds / times[0].seconds;
}

}  // namespace sr
