#pragma once
/// @file variances.hpp
/// Section 9.6: variances of patterns, by formula and measured.

#include <fmt/format.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "convergence.hpp"
#include "course/chapter.hpp"
#include "course/claims.hpp"
#include "pattern_mean.hpp"
#include "point_sets.hpp"
#include "repeated.hpp"
#include "sampling/random_point.hpp"
#include "sampling/sobol_point.hpp"
#include "sampling/stratified_point.hpp"

namespace sr {

/// A variance as the text prints it, by its formula and measured; `digit` is what the last one is worth.
struct PrintedVariance {
    double formula, measured, error, digit;
};

/// Variances that a formula gives and that were measured; the text has both.
class VarianceTable {
public:
    explicit VarianceTable(course::Chapter& chapter) : chapter_{chapter} {}

    /// The mean of n samples, or of n / 2 pairs of them.
    /// @param once  (std::uint64_t repeat) -> the mean
    template <class Once>
    void add(const std::string& what, int repeats, double truth, double formula,
             const PrintedVariance& printed, const Once& once) {
        const Estimate measured =
            mean_square(squared_errors(repeats, chapter_.options().threads, truth, once));
        rows_.add({what, formula, measured.value, measured.error});
        const course::Claims claim{chapter_, "9.6"};
        claim(what + ": variance by formula", printed.formula, formula, printed.digit / 2);
        claim(what + ": variance measured", printed.measured, measured.value, printed.digit / 2);
        claim(what + ": standard error", printed.error, measured.error, printed.digit / 2);
        chapter_.claim_at_most(fmt::format("9.6 {}: their difference [standard errors]", what),
                               std::abs(measured.value - formula) / measured.error, 4);
    }

    /// The mean of n samples of a pattern.
    template <SamplePoint P, class Of>
    void add_pattern(const std::string& what, std::uint32_t n, double truth, double formula,
                     const PrintedVariance& printed, const Of& of) {
        const int curve = ++curves_;
        add(what, n == 16 ? 20'000 : 4'000, truth, formula, printed,
            [&](std::uint64_t seed) { return pattern_mean<P>(curve, seed, n, of); });
    }

    void say() const { chapter_.say(rows_); }

private:
    course::Chapter& chapter_;
    course::Rows     rows_{{"mean of", "variance by formula", "measured", "standard error"}};
    int              curves_ = 0;
};

/// The variance of the jittered mean of x^2, (9.19) as it stands: from a to a + h, the mean of x^4 less the square of
/// that of x^2 is h^2 (a^2 / 3 + a h / 3 + 4 h^2 / 45).
[[nodiscard]] inline double jittered_variance_of_square(int n) {
    const double h   = 1.0 / n;
    double       sum = 0;
    for (int i = 0; i < n; ++i) {
        const double a = i * h;
        sum += h * h * (a * a / 3 + a * h / 3 + 4 * h * h / 45);
    }
    return sum * h * h;
}

/// x and x^2 by 16 samples, x + y and the half of the square under its diagonal by 256.
inline void claim_jitter(course::Chapter& chapter) {
    VarianceTable table(chapter);
    const auto    x         = of_number([](double u) { return u; });
    const auto    square    = of_number([](double u) { return u * u; });
    const auto    sum       = of_pair([](Vector2<double> u) { return u.x + u.y; });
    const auto    half      = of_pair([](Vector2<double> u) { return u.x + u.y < 1 ? 1.0 : 0.0; });
    const double  of_square = jittered_variance_of_square(16);
    table.add_pattern<RandomPoint>("x, random", 16, 0.5, 1.0 / 12 / 16, {0.00521, 0.00520, 0.00005, 1e-5}, x);
    table.add_pattern<StratifiedPoint>("x, jittered", 16, 0.5, 1.0 / 12 / 4096,
                                       {2.03e-5, 2.07e-5, 2e-7, 1e-7}, x);
    table.add_pattern<RandomPoint>("x^2, random", 16, 1.0 / 3, 4.0 / 45 / 16,
                                   {0.00556, 0.00559, 0.00006, 1e-5}, square);
    table.add_pattern<StratifiedPoint>("x^2, jittered", 16, 1.0 / 3, of_square,
                                       {2.71e-5, 2.73e-5, 3e-7, 1e-7}, square);
    table.add_pattern<RandomPoint>("x + y, random", 256, 1, 1.0 / 6 / 256, {6.51e-4, 6.36e-4, 1.4e-5, 1e-6},
                                   sum);
    table.add_pattern<StratifiedPoint>("x + y, jittered", 256, 1, 1.0 / 6 / 65536,
                                       {2.54e-6, 2.66e-6, 6e-8, 1e-8}, sum);
    table.add_pattern<SobolPoint>("x + y, Sobol', scrambled", 256, 1, 1.0 / 6 / 16777216,
                                  {9.9e-9, 1.01e-8, 2e-10, 1e-10}, sum);
    table.add_pattern<RandomPoint>("half, random", 256, 0.5, 1.0 / 4 / 256, {9.77e-4, 9.97e-4, 2.2e-5, 1e-6},
                                   half);
    table.add_pattern<StratifiedPoint>("half, jittered", 256, 0.5, 1.0 / 4 / 4096,
                                       {6.10e-5, 6.19e-5, 1.3e-6, 1e-7}, half);
    table.say();
}

/// Means of two samples, the second of which is 1 - u.
inline void claim_antithetic_pairs(course::Chapter& chapter) {
    VarianceTable table(chapter);
    const auto    once = [](int curve, bool antithetic, const auto& f) {
        return [=](std::uint64_t seed) {
            Rng          rng{seed, curve, 0, 0};
            const double u = rng.uniform<double>(), v = antithetic ? 1 - u : rng.uniform<double>();
            return (f(u) + f(v)) / 2;
        };
    };
    constexpr int repeats = 100'000;
    const auto    square  = [](double u) { return u * u; };
    const auto    valley  = [](double u) { return (u - 0.5) * (u - 0.5); };
    table.add("x^2, two", repeats, 1.0 / 3, 2.0 / 45, {0.0444, 0.0444, 0.0002, 1e-4}, once(1, false, square));
    table.add("x^2, a pair", repeats, 1.0 / 3, 1.0 / 180, {0.00556, 0.00555, 0.00002, 1e-5},
              once(2, true, square));
    table.add("(x - 1/2)^2, two", repeats, 1.0 / 12, 1.0 / 360, {0.00278, 0.00276, 0.00001, 1e-5},
              once(3, false, valley));
    table.add("(x - 1/2)^2, a pair", repeats, 1.0 / 12, 1.0 / 180, {0.00556, 0.00555, 0.00002, 1e-5},
              once(4, true, valley));
    table.say();
}

/// Of the scrambled means of 256 points, 256 of them: their error is known from how they differ, and they are right on
/// average. Sobol's points as they are have an error, too.
inline void claim_scrambled_mean(course::Chapter& chapter) {
    const Bump f;
    Running    means;
    for (std::uint64_t seed = 0; seed < 256; ++seed)
        means.add(pattern_mean<SobolPoint>(9, seed, 256, of_pair(f)));
    double as_it_is = 0;
    for (const auto& p : sobol_set("", 256).points) as_it_is += f(p) / 256;
    const course::Claims claim{chapter, "9.6"};
    claim("bump: integral", 0.557746, Bump::integral(), 5e-7);
    claim("bump, Sobol', 256 points: mean", 0.559594, as_it_is, 5e-7);
    claim("bump, scrambled: mean of 256 means", 0.557747, means.mean(), 5e-7);
    claim("bump, scrambled: standard error of one mean", 7.8e-5, std::sqrt(means.variance()), 5e-7);
    claim("bump, scrambled: standard error of all", 4.9e-6, means.standard_error(), 5e-8);
    claim("bump, Sobol': error [errors of one scrambled mean]", 24,
          std::abs(as_it_is - Bump::integral()) / std::sqrt(means.variance()), 0.5);
    chapter.claim_at_most("9.6 bump, scrambled: error of the mean of means [standard errors]",
                          std::abs(means.mean() - Bump::integral()) / means.standard_error(), 4);
}

/// How many of 64 squares, and of as many columns, the six patterns' 64 points hit.
inline void claim_boxes(course::Chapter& chapter, const std::vector<PointSet>& sets) {
    const std::vector<std::pair<int, int>> printed{{40, 39}, {64, 39}, {55, 64},
                                                   {17, 31}, {64, 64}, {64, 64}};
    const course::Claims                   claim{chapter, "9.6"};
    course::Rows                           rows{{"points", "squares hit", "columns hit"}};
    for (std::size_t i = 0; i < sets.size(); ++i) {
        const int squares = boxes_hit(sets[i].points, 8, 8), columns = boxes_hit(sets[i].points, 64, 1);
        rows.add({sets[i].name, double(squares), double(columns)});
        claim(sets[i].name + ": squares hit, of 64", printed[i].first, squares, 0);
        claim(sets[i].name + ": columns hit, of 64", printed[i].second, columns, 0);
    }
    chapter.say(rows);
}

}  // namespace sr
