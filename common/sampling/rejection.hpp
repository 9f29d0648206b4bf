#pragma once
/// @file rejection.hpp
/// The rejection method: numbers, points or directions that follow f, which need not be normalised, from ones that
/// follow another density p.
///
///     const auto one = sample_by_rejection(rng, draw, p, c, f, 1000);
///     if (one) use(one->x);  // after one->trials, on average c / (integral of f)

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <optional>
#include <stdexcept>
#include <type_traits>

namespace sr {

template <class X>
struct Accepted {
    X   x;
    int trials;  ///< this one and those that were refused before it
};

/// Draws a number xi and an X from p until xi c p(X) <= f(X). None if all trials are refused: in many dimensions, or
/// where f is narrow, few are ever accepted, and a loop without an end would look like one that hangs.
/// @param random       with uniform<double>(), in [0, 1)
/// @param draw         (random) -> X, with the density p
/// @param p            (X) -> its density, double; > 0 of what is drawn
/// @param c            so large that f <= c p everywhere
/// @param f            (X) -> double, at least 0
/// @param most_trials  >= 1
/// @throws std::domain_error if f is negative, not finite or more than c p, beyond rounding, at a point drawn: what
///         has been accepted does not follow f
template <class Random, class Draw, class Density, class Target,
          class X = std::remove_cvref_t<std::invoke_result_t<const Draw&, Random&>>>
[[nodiscard]] std::optional<Accepted<X>> sample_by_rejection(Random& random, const Draw& draw,
                                                             const Density& p, double c, const Target& f,
                                                             int most_trials) {
    constexpr double rounding = 1 + 8 * std::numeric_limits<double>::epsilon();
    for (int trial = 1; trial <= most_trials; ++trial) {
        const double xi       = random.template uniform<double>();
        const X      x        = draw(random);
        const double envelope = c * p(x), target = f(x);
        if (!(target >= 0 && target <= envelope * rounding && std::isfinite(envelope)))
            throw std::domain_error(fmt::format(
                "rejection: f = {} and c p = {} at a point drawn; must be 0 <= f <= c p, and finite", target,
                envelope));
        // xi may be 0, and would let pass what must never come
        if (target > 0 && xi * envelope <= target) return Accepted<X>{x, trial};
    }
    return std::nullopt;
}

}  // namespace sr
