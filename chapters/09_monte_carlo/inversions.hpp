#pragma once
/// @file inversions.hpp
/// What section 9.3 shows and claims.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <tuple>
#include <utility>
#include <vector>

#include "course/claims.hpp"
#include "course/number.hpp"
#include "inversion_diagram.hpp"
#include "math/extremes.hpp"
#include "numeric_inversion.hpp"
#include "sampler_test.hpp"
#include "sampling/philox.hpp"
#include "sampling/piecewise_constant.hpp"
#include "sampling/rng.hpp"
#include "sampling/triangle_points.hpp"

namespace sr {

inline void show_inversion(course::Chapter& chapter) {
    auto diagram = chapter.diagram("inversion", "A density, its integral, and the inverse");
    draw_inversion(diagram);
    diagram.caption(
        "Ten unit numbers, equally far apart, are ten angles, close together where $p$ is large. Orange: one "
        "of them on its way.");
}

/// Points of a triangle by the square root, and by what comes to mind first.
inline void claim_triangle(course::Chapter& chapter) {
    const int            threads = chapter.options().threads;
    const course::Claims claim{chapter, "9.3"};
    const auto           right = moments_of(
                  931, [](Rng& rng) { return sample_triangle(draw_pair(rng)).y; }, threads);
    const auto wrong = moments_of(
        932,
        [](Rng& rng) {
            const auto u = draw_pair(rng);
            return u.y * (1 - u.x);
        },
        threads);
    claim("triangle: mean by the root", 0.3334, right.mean.value, 5e-5);
    claim("triangle: mean without it", 0.2501, wrong.mean.value, 5e-5);
    claim("triangle: variance by the root", 0.0556, right.variance.value, 5e-5);
    chapter.claim_at_most("9.3 triangle: mean and variance off [their standard errors]",
                          max_or_nan(std::abs(right.mean.value - 1.0 / 3) / right.mean.error,
                                     std::abs(right.variance.value - 1.0 / 18) / right.variance.error),
                          4);
}

inline void show_numeric_inversion(course::Chapter& chapter) {
    const course::Claims      claim{chapter, "9.3"};
    const std::vector<double> printed{10.4, 15.5, 10.4};
    course::Rows              table{{"density", "evaluations of P", "time, formula's"}};
    std::size_t               row = 0;
    for (const Invertible& one : invertible()) {
        const double asked = evaluations(one);
        claim(fmt::format("{}: evaluations for a number", one.name), printed[row++], asked, 0.05);
        if (one.formula)
            chapter.claim_at_most(fmt::format("9.3 {}: what is found less the formula", one.name),
                                  inversion_error(one), 1e-8);
        table.add(
            {one.name, asked, one.formula ? course::Cell(slower_than_formula(one)) : course::Cell("none")});
    }
    chapter.say(table);
}

/// How many of 2^32 integers become 1 in float, times 2^-32: they are the last ones.
[[nodiscard]] inline int words_that_become_one() {
    int ones = 0;
    for (std::uint32_t word = 0xffffffff; float(word) * 0x1p-32F == 1; --word) ++ones;
    return ones;
}

/// The bin in which the shares of 0, 1, 0, 1 first reach u: not the one to draw from.
[[nodiscard]] inline int first_bin_to_reach(double u) {
    constexpr std::array below{0.0, 0.0, 0.5, 0.5, 1.0};  // the share of what lies below each bin, and 1
    return int(std::lower_bound(below.begin(), below.end(), u) - below.begin()) - 1;
}

/// What formulas make of xi = 1, and of the last number below.
inline void claim_xi_of_one(course::Chapter& chapter) {
    const auto exponential = [](double xi) { return -std::log(1 - xi); };
    const auto weight      = [](double xi) {  // of a direction by the cosine: cosine over density
        const double cosine = std::sqrt(1 - xi);
        return std::abs(cosine / (cosine / std::numbers::pi));
    };
    const double last = 1 - 0x1p-53;
    course::Rows table{{"xi", "-ln(1 - xi)", "weight by the cosine"}};
    for (const auto& [name, xi] : {std::pair{"1 - 2^-53", last}, {"1", 1.0}})
        table.add({name, fmt::format("{:.1f}", exponential(xi)), fmt::format("{:.4f}", weight(xi))});
    chapter.say(table);
    const course::Claims claim{chapter, "9.3"};
    claim("-ln(1 - xi) of the last xi below 1", 36.7, exponential(last), 0.05);
    claim("of xi = 1: infinite", 1, std::isinf(exponential(1)), 0);
    claim("weight by the cosine of xi = 1: NaN", 1, std::isnan(weight(1)), 0);
}

/// The first words of both generators, as their authors print them.
inline void claim_generators(course::Chapter& chapter) {
    const course::Claims claim{chapter, "9.3"};
    claim("first word of PCG32 for 42, 54", 2'707'161'783, Rng(42, 54).next_u32(), 0);
    claim("first word of Philox for zeros", 1'713'891'541, philox({}, {})[0], 0);
}

/// Unit numbers that are 0 or 1, and pieces of density 0.
inline void claim_ends(course::Chapter& chapter) {
    const course::Claims claim{chapter, "9.3"};
    claim("words that become 1", 128, words_that_become_one(), 0);
    const PiecewiseConstant<double> table(std::array{0.0, 1.0, 0.0, 1.0});
    claim_xi_of_one(chapter);
    course::Rows bins{{"xi", "bin that first reaches it", "bin drawn"}};
    for (const double u : {0.0, 0.25, 0.5, 0.75})
        bins.add({u, first_bin_to_reach(u), int(table.bin_of(table.sample(u)))});
    chapter.say(bins);
    claim("table of 0, 1, 0, 1: bin that first reaches 0, below 0 by", 1, -first_bin_to_reach(0), 0);
    claim("table of 0, 1, 0, 1: bin of u = 0", 1, double(table.bin_of(table.sample(0.0))), 0);
    claim("table of 0, 1, 0, 1: bin of u = 1/2", 3, double(table.bin_of(table.sample(0.5))), 0);
}

/// A right sampler, and one whose exponent is off by a half.
inline void claim_samplers(course::Chapter& chapter) {
    const course::Claims claim{chapter, "9.3"};
    course::Rows         table{{"directions", "p-value, right", "p-value, wrong"}};
    for (const auto& [n, right, wrong, digit] : {std::tuple{1000, 0.911, 0.080, 0.0005},
                                                 {10'000, 0.031, 0.019, 0.0005},
                                                 {100'000, 0.581, 0.0, 0.0005}}) {
        const double p = lobe_p_value(20, n, 1), q = lobe_p_value(19.5, n, 2);
        claim(fmt::format("right sampler, {} directions; p-value", course::whole(n)), right, p, digit);
        if (n < 100'000)
            claim(fmt::format("wrong sampler, {} directions; p-value", course::whole(n)), wrong, q, digit);
        else
            chapter.claim_at_most(fmt::format("9.3 wrong sampler, {} directions; p-value", course::whole(n)),
                                  q, 1e-6);
        table.add({n, p, q});
    }
    chapter.say(table);
}

}  // namespace sr
