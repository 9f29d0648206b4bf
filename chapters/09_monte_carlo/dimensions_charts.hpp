#pragma once
/// @file dimensions_charts.hpp
/// Section 9.8: the errors of grids and samples against the dimension.

#include <fmt/format.h>

#include <cmath>
#include <cstddef>
#include <numbers>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "course/chapter.hpp"
#include "course/claims.hpp"
#include "dimensions.hpp"
#include "math/extremes.hpp"

namespace sr {

inline void chart_dimensions(course::Chapter& chapter, const std::string& name, const std::string& title,
                             const std::string& caption, const std::vector<DimensionLap>& laps) {
    auto chart = chapter.chart(
        name, title + fmt::format(", by {} values", points_in_all),
        course::with_error(
            {.x = "dimensions", .y = "relative error, RMS over seeds", .log = course::axis::y}));
    for (const auto& [method, d, error] : laps)
        if (!(error.value <= 1e-8)) chart.add(method, double(d), error);  // all below are Gauss's
    for (const auto& [method, ink] : {std::pair{"random", course::Ink::blue},
                                      {"Sobol', in fours", course::Ink::purple},
                                      {"Sobol', as one", course::Ink::green},
                                      {"midpoints", course::Ink::amber},
                                      {"Gauss", course::Ink::black}})
        chart.in_ink(method, ink);
    chart.caption(caption);
}

[[nodiscard]] inline Estimate error_of(const std::vector<DimensionLap>& laps, const std::string& method,
                                       int d) {
    for (const auto& lap : laps)
        if (lap.method == method && lap.d == d) return lap.error;
    throw std::out_of_range("no lap of " + method);
}

/// A row of the text's table: errors in d dimensions, of each method; 0: nothing but rounding.
struct PrintedErrors {
    int                 d;
    std::vector<double> errors;
};

inline void claim_errors(course::Chapter& chapter, const std::string& of,
                         const std::vector<DimensionLap>& laps, const std::vector<PrintedErrors>& printed) {
    const std::vector<std::string> methods{"midpoints", "Gauss", "random", "Sobol', in fours",
                                           "Sobol', as one"};
    const course::Claims           claim{chapter, "9.8"};
    course::Rows                   rows{{"integrand", "dimensions", "method", "error", "standard error"}};
    for (const auto& [d, errors] : printed)
        for (std::size_t i = 0; i < methods.size(); ++i) {
            const Estimate error = error_of(laps, methods[i], d);
            rows.add({of, double(d), methods[i], error.value, error.error});
            const std::string what = fmt::format("{}, {} dimensions, {}: relative error", of, d, methods[i]);
            if (errors[i] == 0) {
                chapter.claim_at_most("9.8 " + what + ", below 1e-12", error.value, 1e-12);
                continue;
            }
            const double digit = std::pow(10.0, std::floor(std::log10(errors[i])) - 1);
            claim(what, errors[i], error.value, digit / 2);
        }
    chapter.say(rows);
}

/// The relative error of random samples of SineProduct, exactly: its variance is (pi^2 / 8)^d - 1.
[[nodiscard]] inline double random_error(int d) {
    return std::sqrt((std::pow(std::numbers::pi * std::numbers::pi / 8, d) - 1) / points_in_all);
}

/// The power of n by which the midpoint rule's error of SineProduct falls, from 8 points along each axis to 16. The
/// grid's sum of a product is the product of the axes' sums.
[[nodiscard]] inline double midpoint_power(int d) {
    const auto error = [d](int side) {
        return std::pow(grid_integral({side}, midpoint_rule, SineProduct{}), d) - 1;
    };
    return std::log2(error(8) / error(16)) / d;
}

/// What section 9.8 says of both integrands.
inline void claim_dimensions(course::Chapter& chapter, const std::vector<DimensionLap>& smooth,
                             const std::vector<DimensionLap>& ball) {
    claim_errors(chapter, "smooth", smooth,
                 {{2, {2.0e-4, 0, 0.012, 2.5e-5, 2.7e-5}},
                  {4, {0.026, 0, 0.017, 6.1e-4, 6.0e-4}},
                  {8, {0.63, 0.059, 0.026, 0.020, 0.0087}},
                  {16, {20, 3.1, 0.082, 0.063, 0.062}}});
    claim_errors(chapter, "ball", ball,
                 {{2, {0.0019, 0.00021, 0.0088, 0.0011, 0.0011}},
                  {4, {0.0069, 0.033, 0.020, 0.0080, 0.0068}},
                  {8, {0.082, 0.15, 0.13, 0.10, 0.066}},
                  {10, {0.19, 0.38, 0.35, 0.28, 0.22}}});
    const course::Claims claim{chapter, "9.8"};
    claim("smooth, midpoints in 2 dimensions: power by which the error falls", 1.00, midpoint_power(2),
          0.005);
    claim("smooth, midpoints in 4 dimensions: power by which the error falls", 0.50, midpoint_power(4),
          0.005);
    claim("smooth, midpoints in 8 dimensions: power by which the error falls", 0.25, midpoint_power(8),
          0.005);
    for (const auto& [d, printed] : {std::pair{2, 0.011}, {4, 0.018}, {8, 0.033}, {16, 0.082}})
        claim(fmt::format("smooth, {} dimensions, random: relative error, exactly", d), printed,
              random_error(d), 5e-4);
    claim("smooth, 16 dimensions: what midpoints say over the truth", 21,
          grid_integral(grid_sides(points_in_all, 16), midpoint_rule, SineProduct{}), 0.5);
    const auto over = [&](const std::string& one, const std::string& other, int d) {
        chapter.claim_at_most(fmt::format("9.8 smooth, {} dimensions: error, {} over {}", d, one, other),
                              error_of(smooth, one, d).value / error_of(smooth, other, d).value, 1);
    };
    over("midpoints", "random", 3);
    over("random", "midpoints", 4);
    over("Gauss", "Sobol', as one", 7);
    over("random", "Gauss", 8);
    double worst = 0;
    for (const auto& [method, d, error] : smooth) {
        if (method != "random") continue;
        worst =
            max_or_nan(worst, std::abs(error.value / random_error(d) - 1) * std::sqrt(2.0 * seeds_of_a_lap));
    }
    chapter.claim_at_most("9.8 smooth, random: error less that by its variance [standard errors]", worst, 4);
}

}  // namespace sr
