#pragma once
/// @file roulette_furnace.hpp
/// Section 10.4: paths in a room that shines and reflects alike everywhere, which end by chance. What is known of them
/// in closed form: mean, variance, and what they cost.
/// @see Arvo and Kirk, Particle Transport and Image Synthesis (SIGGRAPH 1990)

#include <cmath>
#include <cstdint>
#include <limits>

#include "math/square.hpp"
#include "sampling/rng.hpp"

namespace sr {

/// Each surface emits 1 and reflects rho of what arrives; after each, a path goes on with the chance q.
/// @pre 0 < rho < 1, 0 < q < 1
struct RouletteFurnace {
    double rho, q;

    /// What one path brings, and on how many surfaces.
    struct Path {
        double light    = 0;
        int    surfaces = 0;
    };

    [[nodiscard]] Path draw(Rng& rng) const {
        Path   path;
        double throughput = 1;
        // who goes on also counts for those who did not
        do {
            path.light += throughput;
            ++path.surfaces;
            throughput *= rho / q;
        } while (rng.uniform<double>() < q);
        return path;
    }

    [[nodiscard]] double mean() const { return 1 / (1 - rho); }
    [[nodiscard]] double surfaces() const { return 1 / (1 - q); }

    /// (10.15), of what one path brings; infinite unless q > rho^2.
    [[nodiscard]] double variance() const {
        if (!(q > square(rho))) return std::numeric_limits<double>::infinity();
        return square(mean()) * square(rho) * (1 - q) / (q - square(rho));
    }

    /// E[X^k] of X = 1 + (rho / q) X' with the chance q, and else 1: by the binomial theorem, with
    /// b_j = q (rho / q)^j, it is 1 + sum_j (k over j) b_j E[X^j]. Infinite if b_k >= 1.
    [[nodiscard]] double moment(int k) const {
        const auto b   = [this](int j) { return q * std::pow(rho / q, j); };
        double     sum = 1, binomial = 1;
        for (int j = 1; j < k; ++j) {
            binomial *= double(k - j + 1) / j;
            sum += binomial * b(j) * moment(j);
        }
        return b(k) < 1 ? sum / (1 - b(k)) : std::numeric_limits<double>::infinity();
    }

    /// One standard error of the variance as n paths show it, by the fourth moment about the mean.
    [[nodiscard]] double error_of_variance(double n) const {
        const double m      = mean();
        const double fourth = moment(4) - 4 * m * moment(3) + 6 * square(m) * moment(2) - 3 * square(m * m);
        return std::sqrt((fourth - square(variance())) / n);
    }
};

/// (10.16): variance times surfaces, in squared means, if what else is random in a path adds `noise` to its variance,
/// in squared means as well.
[[nodiscard]] inline double roulette_cost(const RouletteFurnace& furnace, double noise) {
    return (furnace.variance() / square(furnace.mean()) + noise) * furnace.surfaces();
}

/// The q for which that is least. Without any noise there is none: it falls all the way to q = 1.
/// @pre noise > 0
[[nodiscard]] inline double best_survival(double rho, double noise) {
    const double s = rho / std::sqrt(noise);
    return (square(rho) + s) / (1 + s);
}

}  // namespace sr
