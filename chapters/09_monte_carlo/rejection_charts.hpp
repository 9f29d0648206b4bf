#pragma once
/// @file rejection_charts.hpp
/// Figures 9.7 and 9.9: what is accepted, and what follows if c is too small.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "course/claims.hpp"
#include "math/gauss_legendre.hpp"
#include "moments.hpp"
#include "rejection_example.hpp"
#include "statistics/tests.hpp"

namespace sr {

/// Figure 9.7.
inline void chart_rejection(course::Chapter& chapter) {
    auto chart = chapter.chart("rejection", "300 trials: $\\xi\\, c\\, p(X)$ against $X$",
                               {.x = "$x$", .y = "height"});
    for (int i = 0; i <= 200; ++i) {
        chart.add("$c\\, p$", i / 50.0, fading(i / 50.0));
        chart.add("$f$", i / 50.0, waves(i / 50.0));
    }
    Rng rng{941, 0, 0, 0};
    int accepted = 0, beyond = 0;
    for (int i = 0; i < 300; ++i) {
        const double xi = rng.uniform<double>(), x = draw_fading(rng), height = xi * fading(x);
        const bool   under = height <= waves(x);
        accepted += under;
        beyond += x >= 4;
        if (x < 4) chart.add(under ? "accepted" : "refused", x, height);
    }
    for (const std::string line : {"$c\\, p$", "$f$"}) chart.as_line(line);
    for (const std::string dots : {"accepted", "refused"}) chart.as_points(dots);
    chart.in_ink("$c\\, p$", course::Ink::grey);
    chart.in_ink("$f$", course::Ink::black);
    chart.in_ink("accepted", course::Ink::blue);
    chart.in_ink("refused", course::Ink::vermilion);
    chart.name_at("$c\\, p$", 0.6);  // at the right, all of them are close to 0
    chart.name_at("$f$", 1.9);
    chart.name_at("refused", 1.2);
    chart.name_at("accepted", 0.6);
    chart.caption(
        "Points are uniform under the upper curve; so those under the lower one are uniform there.");
    const course::Claims claim{chapter, "9.4"};
    claim("waves: share that is accepted [%]", 61.8, 100 * waves_integral, 0.05);
    claim("waves: accepted of 300", 191, accepted, 0);
    claim("waves: beyond 4, of 300", 7, beyond, 0);
}

/// What a c of 1/2 draws, where it should be 1.
struct Clipped {
    static constexpr int    samples = 200'000, bins = 40;  // from 0 to `last`, and one more for all beyond
    static constexpr double c = 0.5, last = 4, width = last / bins;

    /// The integral over a bin of f, where it is at most `largest` p.
    [[nodiscard]] static double in_bin(int bin, double largest) {
        double sum = 0;
        for (const auto& [x, weight] : gauss_legendre(16, bin * width, (bin + 1) * width))
            sum += weight * std::min(waves(x), largest * fading(x));
        return sum;
    }

    [[nodiscard]] static double integral(double largest) {
        double sum = 0;
        for (int bin = 0; bin < 10 * bins; ++bin) sum += in_bin(bin, largest);
        return sum;
    }

    /// How many samples the bins should get.
    [[nodiscard]] static std::vector<double> expected(double largest) {
        std::vector<double> counts;
        const double        whole = integral(largest);
        double              rest  = samples;
        for (int bin = 0; bin < bins; ++bin) {
            counts.push_back(samples * in_bin(bin, largest) / whole);
            rest -= counts.back();
        }
        counts.push_back(rest);
        return counts;
    }

    /// And how many they do get.
    [[nodiscard]] static std::vector<std::uint64_t> drawn() {
        std::vector<std::uint64_t> counts(bins + 1);
        Rng                        rng{942, 0, 0, 0};
        for (int i = 0; i < samples; ++i)
            ++counts[std::size_t(std::min(trusting_rejection(rng, c) / width, double(bins)))];
        return counts;
    }
};

/// Figure 9.9.
inline void chart_clipped(course::Chapter& chapter) {
    auto         chart  = chapter.chart("clipped", "Rejection with a $c$ that is half of what it must be",
                                        course::with_error({.x = "$x$", .y = "density"}));
    const auto   counts = Clipped::drawn();
    const double right = Clipped::integral(1), clipped = Clipped::integral(Clipped::c);
    for (int bin = 0; bin < Clipped::bins; ++bin) {
        const Estimate seen = share(int(counts[std::size_t(bin)]), Clipped::samples);
        chart.add("drawn", (bin + 0.5) * Clipped::width,
                  {seen.value / Clipped::width, seen.error / Clipped::width});
    }
    const std::string f = "$f$", cut = "$\\min(f, c\\, p)$";
    for (int i = 0; i <= 200; ++i) {
        const double x = Clipped::last * i / 200;
        chart.add(f, x, {waves(x) / right, 0});
        chart.add(cut, x, {std::min(waves(x), Clipped::c * fading(x)) / clipped, 0});
    }
    chart.as_points("drawn");
    chart.as_line(f);
    chart.as_line(cut);
    chart.in_ink("drawn", course::Ink::black);
    chart.in_ink(f, course::Ink::blue);
    chart.in_ink(cut, course::Ink::vermilion);
    chart.name_at(f, 0.4);  // at the right, all of them are close to 0
    chart.name_at(cut, 0.1);
    chart.name_at("drawn", 1.45);
    chart.caption(
        "All curves with an integral of 1. What is drawn is cut off where $f > c\\, p$, and too dense "
        "elsewhere.");
    const course::Claims claim{chapter, "9.4"};
    claim("c too small: p-value of what is drawn against min(f, c p)", 0.945,
          chi_square_test(counts, Clipped::expected(Clipped::c)).p, 0.0005);
    chapter.claim_at_most("9.4 c too small: p-value of what is drawn against f",
                          chi_square_test(counts, Clipped::expected(1)).p, 1e-20);
}

/// How soon the tool notices that c is too small.
inline void claim_noticed(course::Chapter& chapter) {
    const auto draws = [](double c) {
        Rng     rng{943, 0, 0, 0};
        Running mean;
        for (int i = 0; i < 10'000; ++i) mean.add(draws_until_noticed(rng, c, 1'000'000));
        return mean.mean();
    };
    const course::Claims claim{chapter, "9.4"};
    claim("c of 1/2: trials until it is noticed", 1.46, draws(0.5), 0.005);
    claim("c of 0.99: trials until it is noticed", 11.7, draws(0.99), 0.05);
}

}  // namespace sr
