#pragma once
/// @file sum_charts.hpp
/// Section 9.10: what becomes of sums in float.

#include <cstdint>
#include <vector>

#include "course/claims.hpp"
#include "statistics/running.hpp"
#include "sums.hpp"

namespace sr {

/// Means of uniform numbers as they are added up, to 2^26.
inline void chart_sums(course::Chapter& chapter) {
    auto     chart = chapter.chart("sums", "The mean of uniform numbers, added up in float",
                                   {.x = "numbers, in millions", .y = "sum / number"});
    Rng      rng{1030, 0, 0, 0};
    float    plain = 0;
    double   exact = 0;
    KahanSum kahan;
    for (int n = 1; n <= 1 << 26; ++n) {
        const float x = rng.uniform<float>();
        plain += x;
        exact += x;
        kahan.add(x);
        if (n % (1 << 20) != 0) continue;
        chart.add("float", n * 1e-6, plain / double(n));
        chart.add("float, Kahan", n * 1e-6, kahan.value() / double(n));
    }
    for (const auto* way : {"float", "float, Kahan"}) chart.as_line(way);
    chart.caption("In float, $2^{24} + x = 2^{24}$ for all $x < 1$.");
    const course::Claims claim{chapter, "9.10"};
    const double         n = 1 << 26;
    claim("mean of 2^26 ones, added up in float", 0.25, sum_of_ones(1 << 26) / n, 0);
    claim("mean of 2^26 uniform numbers, in float", 0.25, plain / n, 0);
    claim("in double", 0.49999, exact / n, 5e-6);
    claim("in float, Kahan's", 0.49999, kahan.value() / n, 5e-6);
}

/// Variance by the textbook, and sums in another order.
inline void claim_sums(course::Chapter& chapter) {
    const course::Claims claim{chapter, "9.10"};
    Rng                  rng{2, 0, 0, 0};
    std::vector<float>   values;
    Running              running;
    for (int i = 0; i < 1'000'000; ++i) {
        values.push_back(1000 + 0.01F * rng.uniform<float>());
        running.add(values.back());
    }
    claim("1000 + 0.01 xi, variance by E[x^2] - E[x]^2 in float, below 0 by", 23645,
          -textbook_variance(values), 0.5);
    claim("the same by Welford", 8.33e-6, running.variance(), 5e-9);

    Rng other{3, 0, 0, 0};
    values.clear();
    double exact = 0;
    for (int i = 0; i < 1 << 20; ++i) {
        values.push_back(other.uniform<float>());
        exact += values.back();
    }
    claim("2^20 numbers, exactly", 524134.515, exact, 5e-4);
    claim("from the first", 524124.781, sum_forward(values), 5e-4);
    claim("from the last", 524134.281, sum_backward(values), 5e-4);
    claim("in 8 pieces", 524133.219, sum_in_pieces(values, 8), 5e-4);
    claim("in 4 pieces", 524131.281, sum_in_pieces(values, 4), 5e-4);
    claim("in pairs", 524134.5, sum_pairwise(values), 5e-4);
}

}  // namespace sr
