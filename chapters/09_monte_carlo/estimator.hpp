#pragma once
/// @file estimator.hpp

#include "sampling/rng.hpp"
#include "statistics/running.hpp"

namespace sr {

/// The estimator (9.2) with what its samples say of its error.
/// @param f  (x) -> double
/// @param p  a density, with sample(u) and pdf(x)
/// @param n  samples
template <class F, class Density>
[[nodiscard]] Running monte_carlo(Rng& rng, const F& f, const Density& p, int n) {
    Running mean;  // (9.2) of f over p
    for (int i = 0; i < n; ++i) {
        const double x = p.sample(rng.uniform<double>());
        mean.add(f(x) / p.pdf(x));
    }
    return mean;
}

}  // namespace sr
