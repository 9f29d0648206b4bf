#pragma once
/// @file partial_sums_chart.hpp
/// Section 10.5: three programs, one series.

#include <fmt/format.h>

#include <array>
#include <cstddef>
#include <string>

#include "course/claims.hpp"
#include "partial_sums.hpp"

namespace sr {

struct SeriesProgram {
    std::string name, counts;
    DoubleSpectrum (*sum)(int k);
};

[[nodiscard]] inline std::array<SeriesProgram, 3> series_programs() {
    return {{{"recursion", "rays $k$ deep", sum_by_recursion},
             {"radiosity", "$k$ steps of Jacobi", sum_by_jacobi},
             {"paths", "paths of fewer than $k$ bounces", sum_by_paths}}};
}

/// The partial sums of all three, side by side at each k.
inline void chart_partial_sums(course::Chapter& chapter) {
    auto          chart = chapter.chart("partial_sums", "One series, by three programs",
                                        {.x = "$k$", .y = "radiance [W/(m$^2$ sr)]"});
    constexpr int last  = 10;
    for (const float rho : {room_reflectance.r, room_reflectance.g, room_reflectance.b}) {
        const auto name = fmt::format("$\\rho = {}$", rho);
        for (int k = 1; k <= last; ++k) chart.add(name, k, partial_sum(double(rho), k));
        chart.as_line(name);
        chart.in_ink(name, course::Ink::grey);
    }
    const auto programs = series_programs();
    for (std::size_t i = 0; i < programs.size(); ++i) {
        for (int k = 1; k <= last; ++k) {
            const auto L = programs[i].sum(k);
            for (const double one : {L.r, L.g, L.b})
                chart.add(programs[i].counts, k + 0.2 * (double(i) - 1), one);
        }
        chart.as_points(programs[i].counts);
    }
    chart.caption("The three of a $k$ are drawn side by side; lines are the closed form.");
}

inline void claim_partial_sums(course::Chapter& chapter) {
    const course::Claims   claim{chapter, "10.5"};
    using Primary = double DoubleSpectrum::*;
    struct Row {
        const char* rho;
        Primary     primary;
        int         k;
        double      sum, digit;
    };
    for (const auto& program : series_programs())
        for (const auto& [rho, primary, k, sum, digit] : {Row{"0.5", &DoubleSpectrum::g, 1, 1, 1e-6},
                                                          {"0.5", &DoubleSpectrum::g, 5, 1.9375, 1e-6},
                                                          {"0.5", &DoubleSpectrum::g, 10, 1.998046875, 1e-6},
                                                          {"0.8", &DoubleSpectrum::r, 5, 3.3616, 1e-4},
                                                          {"0.2", &DoubleSpectrum::b, 5, 1.2496, 1e-4}})
            claim(fmt::format("{}, rho {}: radiance for k = {}", program.name, rho, k), sum,
                  program.sum(k).*primary, digit / 2);
}

}  // namespace sr
