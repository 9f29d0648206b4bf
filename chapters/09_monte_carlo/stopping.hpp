#pragma once
/// @file stopping.hpp
/// Section 9.9: hit or miss, until the estimated error is small enough. What that does is computed exactly, from the
/// probability of each number of hits after each number of samples.

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "math/square.hpp"
#include "sampling/rng.hpp"
#include "statistics/estimate.hpp"

namespace sr {

/// When to stop: from `least` samples on, as soon as the error is said to be at most `tolerance`.
struct StoppingRule {
    int    least     = 16;
    double tolerance = 0.01;
    double (*error)(int hits, int n);  ///< standard error of hits / n, as the rule estimates it

    [[nodiscard]] bool stops(int hits, int n) const { return n >= least && error(hits, n) <= tolerance; }
};

/// sqrt(s^2 / n) with the unbiased s^2 of the samples: 0 where all are alike.
[[nodiscard]] inline double error_of_samples(int hits, int n) {
    const double share = double(hits) / n;
    return std::sqrt(share * (1 - share) / (n - 1));
}

/// Laplace's, which takes one hit and one miss for seen: never 0.
[[nodiscard]] inline double error_never_zero(int hits, int n) {
    return share(hits, std::size_t(n)).error;
}

/// What becomes of an estimate of p.
struct Stopped {
    double mean    = 0;
    double rms     = 0;  ///< error, root mean square
    double samples = 0;  ///< on average
    double misses  = 0;  ///< probability to end with no hit at all
};

/// All ways that it can go, each with its probability.
/// @pre the rule stops at last, whatever the hits; 0 < p < 1
[[nodiscard]] inline Stopped stopped(const StoppingRule& rule, double p) {
    Stopped             end;
    std::vector<double> going{1};  // probability of k hits, of what has not stopped after n samples
    double              left = 1;
    for (int n = 1; left > 1e-14; ++n) {
        going.push_back(0);
        left = 0;
        for (int k = n; k >= 0; --k) {
            auto& one = going[std::size_t(k)];
            one       = one * (1 - p) + (k > 0 ? going[std::size_t(k - 1)] * p : 0);
            if (one > 0 && rule.stops(k, n)) {
                const double value = double(k) / n;
                end.mean += one * value;
                end.rms += one * square(value - p);
                end.samples += one * n;
                if (k == 0) end.misses += one;
                one = 0;
            }
            left += one;
        }
    }
    end.rms = std::sqrt(end.rms);
    return end;
}

/// One run of it.
[[nodiscard]] inline double run_until_stopped(const StoppingRule& rule, double p, Rng& rng) {
    int hits = 0, n = 0;
    do {
        hits += rng.uniform<double>() < p ? 1 : 0;
        ++n;
    } while (!rule.stops(hits, n));
    return double(hits) / n;
}

/// How many samples a pilot asks for: as many as bring the error down to the tolerance, if its own share is right.
[[nodiscard]] inline int samples_asked_for(const StoppingRule& rule, int hits) {
    const double variance = square(error_never_zero(hits, rule.least)) * rule.least;
    return int(std::ceil(variance / square(rule.tolerance)));
}

/// A pilot of `least` samples decides how many others there are, and they alone are the estimate.
[[nodiscard]] inline Stopped decided_by_pilot(const StoppingRule& rule, double p) {
    const int m      = rule.least;
    double    chance = std::pow(1 - p, m);  // of so many hits
    Stopped   end{.mean = p};
    for (int hits = 0; hits <= m; ++hits) {
        const int n = samples_asked_for(rule, hits);
        end.rms += chance * p * (1 - p) / n;
        end.samples += chance * (m + n);
        end.misses += chance * std::pow(1 - p, n);
        chance *= double(m - hits) / (hits + 1) * p / (1 - p);
    }
    end.rms = std::sqrt(end.rms);
    return end;
}

[[nodiscard]] inline double run_by_pilot(const StoppingRule& rule, double p, Rng& rng) {
    int hits = 0;
    for (int i = 0; i < rule.least; ++i) hits += rng.uniform<double>() < p ? 1 : 0;
    const int n = samples_asked_for(rule, hits);
    hits        = 0;
    for (int i = 0; i < n; ++i) hits += rng.uniform<double>() < p ? 1 : 0;
    return double(hits) / n;
}

}  // namespace sr
