#pragma once
/// @file density_claims.hpp
/// Section 9.5: variances in closed form, and as they are measured.

#include <cstdint>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "control_variate.hpp"
#include "course/claims.hpp"
#include "moments.hpp"
#include "power_density.hpp"
#include "two_densities.hpp"
#include "two_lamps.hpp"

namespace sr {

/// A way to draw, its variance in closed form, and how the text prints that, the measured one and its error. A last
/// digit of either is worth `digit`.
struct VarianceRow {
    std::string                 name;
    std::function<double(Rng&)> draw;
    double                      exact;
    double                      printed, measured, error, digit;
};

/// Claims a table of the text. @param stream  of the first row's random numbers
inline void claim_variances(course::Chapter& chapter, std::uint64_t stream,
                            const std::vector<VarianceRow>& rows) {
    const course::Claims claim{chapter, "9.5"};
    course::Rows         table{{"drawn by", "variance", "measured", "standard error"}};
    for (const auto& row : rows) {
        const auto seen = moments_of(stream++, row.draw, chapter.options().threads).variance;
        table.add({row.name, row.exact, seen.value, seen.error});
        claim(row.name + ": variance", row.printed, row.exact, row.digit / 2);
        claim(row.name + ": variance, measured", row.measured, seen.value, row.digit / 2);
        claim(row.name + ": its standard error", row.error, seen.error, row.digit / 2);
    }
    chapter.say(table);
}

inline void claim_squares(course::Chapter& chapter) {
    const auto by = [](double a) { return [=](Rng& rng) { return draw_square({a}, rng); }; };
    claim_variances(chapter, 101,
                    {{"p = 1", by(1), variance_of_square(1), 0.0889, 0.0887, 0.0002, 1e-4},
                     {"p = 2x", by(2), variance_of_square(2), 0.01389, 0.01387, 0.00003, 1e-5},
                     {"p = 3x^2", by(3), variance_of_square(3), 0, 0, 0, 1e-15},
                     {"p = 4x^3", by(4), variance_of_square(4), 0.0139, 0.0151, 0.0014, 1e-4}});
}

inline void claim_unseen(course::Chapter& chapter) {
    const auto seen = moments_of(
                          55, [](Rng& rng) { return draw_square({5.5}, rng); }, chapter.options().threads)
                          .variance;
    course::Claims{chapter, "9.5"}("a = 5.5: variance, measured over exact", 0.55,
                                   seen.value / variance_of_square(5.5), 5e-3);
}

inline void claim_two_lamps(course::Chapter& chapter) {
    const auto row = [](std::string name, double chance, double printed, double measured, double error,
                        double digit) {
        const TwoLamps lamps{chance};
        return VarianceRow{std::move(name),
                           [=](Rng& rng) { return lamps.draw(rng); },
                           lamps.variance(),
                           printed,
                           measured,
                           error,
                           digit};
    };
    claim_variances(chapter, 111,
                    {row("the brighter one with 1/2", 0.5, 64, 64, 0, 1),
                     row("with 9/10", 0.9, 0, 0, 0, 1e-12), row("with 1/10", 0.1, 711, 713, 3, 1)});
}

inline void claim_control_variates(course::Chapter& chapter) {
    const auto row = [](std::string name, double beta, double printed, double measured, double error,
                        double digit) {
        const ExponentialLessLine less{beta};
        return VarianceRow{std::move(name),
                           [=](Rng& rng) { return less.draw(rng); },
                           less.variance(),
                           printed,
                           measured,
                           error,
                           digit};
    };
    const double best = ExponentialLessLine::best();
    claim_variances(
        chapter, 121,
        {row("beta = 0", 0, 0.2420, 0.2415, 0.0004, 1e-4), row("beta = 1", 1, 0.0437, 0.0436, 0.0001, 1e-4),
         row("beta = 1.690", best, 0.00394, 0.00393, 0.00001, 1e-5)});
    course::Claims{chapter, "9.5"}("best beta", 1.690, best, 5e-4);
    course::Claims{chapter, "9.5"}("variance, none over best", 61,
                                   ExponentialLessLine{0}.variance() / ExponentialLessLine{best}.variance(),
                                   0.5);
}

inline void claim_two_densities(course::Chapter& chapter) {
    const auto both_by = [](double a) {
        return [=](Rng& rng) {
            const double one = draw_square({a}, rng), other = draw_square({a}, rng);
            return (one + other) / 2;
        };
    };
    const auto weighed = [](Heuristic heuristic) {
        return [=](Rng& rng) { return draw_weighed_square(heuristic, rng); };
    };
    const auto mixed = [](Rng& rng) {
        const double one = draw_mixed_square(rng), other = draw_mixed_square(rng);
        return (one + other) / 2;
    };
    claim_variances(
        chapter, 131,
        {{"two of p = 1", both_by(1), variance_of_square(1) / 2, 0.0444, 0.0442, 0.0001, 1e-4},
         {"two of p = 2x", both_by(2), variance_of_square(2) / 2, 0.00694, 0.00695, 0.00002, 1e-5},
         {"two of the mixture", mixed, variance_mixed() / 2, 0.02044, 0.02052, 0.00005, 1e-5},
         {"one of each, balance", weighed(Heuristic::balance), variance_weighed(Heuristic::balance), 0.01872,
          0.01875, 0.00005, 1e-5},
         {"one of each, power", weighed(Heuristic::power), variance_weighed(Heuristic::power), 0.01818,
          0.01820, 0.00005, 1e-5}});
}

}  // namespace sr
