#pragma once
/// @file estimators.hpp
/// What section 9.1 shows and claims.

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <utility>
#include <vector>

#include "course/claims.hpp"
#include "coverage.hpp"
#include "hit_or_miss.hpp"
#include "running_means.hpp"
#include "sample_sizes.hpp"
#include "statistics/slope.hpp"

namespace sr {

/// Figure 9.1, and what the bars add up to.
inline void show_sample_sizes(course::Chapter& chapter) {
    constexpr int n = 10;
    auto diagram = chapter.diagram("sample_sizes", "Three ways to cover the area under $e^x$ with ten bars");
    const auto even = samples(EvenDensity{}, 7, n), rising = samples(RisingDensity{}, 7, n);
    draw_bars(diagram, 0, "ten steps", steps(n), course::Ink::grey);
    draw_bars(diagram, 4.6, "$p = 1/2$", even, course::Ink::blue);
    draw_bars(diagram, 9.2, "$p = (1 + 2x)/6$", rising, course::Ink::vermilion);
    diagram.caption("Samples overlap and leave gaps. Where they come often each is narrow.");
    const course::Claims claim{chapter, "9.1"};
    claim("exact integral", 6.389, growth_integral(), 0.0005);
    claim("ten steps", 6.378, sums_of(steps(n)).area, 0.0005);
    claim("ten samples, even", 5.50, sums_of(even).area, 0.005);
    claim("ten samples, rising", 6.03, sums_of(rising).area, 0.005);
    claim("ten samples, rising: sum of their widths", 2.04, sums_of(rising).widths, 0.005);
    claim("rising, sum of the widths of 100 000 samples", 2.00,
          sums_of(samples(RisingDensity{}, 8, 100'000)).widths, 0.005);
    claim("variance of a sample, even", 12.78, growth_variance(EvenDensity{}), 0.005);
    claim("variance of a sample, rising", 1.438, growth_variance(RisingDensity{}), 0.0005);
}

/// Do repeats lie as far off as they say themselves?
inline void show_standard_errors(course::Chapter& chapter) {
    const course::Claims claim{chapter, "9.1"};
    course::Rows         table{{"samples", "within 1 standard error [%]", "2", "3"}};
    for (const auto& [n, printed] : {std::pair{4, std::array{59.6, 81.8, 88.6}},
                                     {16, {67.3, 93.0, 98.5}},
                                     {64, {69.1, 95.0, 99.3}},
                                     {1024, {68.8, 95.0, 99.8}}}) {
        const auto within = coverage(n, 5000, chapter.options().threads);
        table.add({n, within[0].value, within[1].value, within[2].value});
        for (std::size_t k = 0; k < 3; ++k)
            claim(fmt::format("{} samples: within {} of its standard errors [%]", n, k + 1), printed[k],
                  within[k].value, 0.05);
    }
    chapter.say(table);
    for (const auto& [k, printed] : {std::pair{1, 68.3}, {2, 95.4}, {3, 99.7}})
        claim(fmt::format("normally distributed: within {} of them [%]", k), printed,
              100 * std::erf(k / std::numbers::sqrt2), 0.05);
    claim("standard error of a share in the first column [%]", 0.7,
          coverage(4, 5000, chapter.options().threads)[0].error, 0.05);
}

/// How errors fall with n.
inline void show_errors(course::Chapter& chapter) {
    std::vector<double>   efforts;
    std::vector<Estimate> even, rising;
    course::Rows table{{"samples", "error, even", "standard error", "error, rising", "standard error"}};
    for (int n = 16; n <= 4096; n *= 4) {
        const Estimate a = growth_error(EvenDensity{}, n, 1000, chapter.options().threads);
        const Estimate b = growth_error(RisingDensity{}, n, 1000, chapter.options().threads);
        table.add({n, a.value, a.error, b.value, b.error});
        efforts.push_back(n);
        even.push_back(a);
        rising.push_back(b);
    }
    chapter.say(table);
    const course::Claims claim{chapter, "9.1"};
    const Slope          of_even = log_log_slope(efforts, even), of_rising = log_log_slope(efforts, rising);
    claim("power by which the error falls, even", 0.500, -of_even.value, 0.0005);
    claim("its standard error", 0.005, of_even.standard_error, 0.0005);
    claim("power by which the error falls, rising", 0.501, -of_rising.value, 0.0005);
    claim("its standard error", 0.005, of_rising.standard_error, 0.0005);
    claim("error with 16 samples over that with 64", 2.05, even[0].value / even[1].value, 0.005);
    claim("error of 1024 samples, even over rising", 2.99, even[3].value / rising[3].value, 0.005);
}

/// (9.2) of a disk's indicator.
inline void show_hit_or_miss(course::Chapter& chapter) {
    const course::Claims claim{chapter, "9.1"};
    const Running        pi = hit_or_miss(1000, chapter.options().threads);
    claim("pi by a million points", 3.1394, pi.mean(), 5e-5);
    claim("its standard error", 0.0016, pi.standard_error(), 5e-5);
    const double p = std::numbers::pi / 4;
    claim("variance of a point", 2.697, 16 * p * (1 - p), 0.0005);
    claim("points for an error of 1 %", 2732, (1 - p) / p * 1e4, 0.5);
    claim("variance of a point, measured", 2.702, pi.variance(), 0.0005);
}

}  // namespace sr
