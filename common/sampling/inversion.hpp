#pragma once
/// @file inversion.hpp
/// The inversion method where P^-1 has no formula: x with P(x) = u is found by looking for it.

#include <concepts>
#include <optional>

#include "math/bracketed_root.hpp"
#include "math/interval.hpp"

namespace sr {

/// Where a cumulative density is u, and how often it was asked: what a formula would have spared.
template <std::floating_point T>
struct Inversion {
    T   x;
    int evaluations;
};

/// The number x in `range` with P(x) = u, to two units in the last place as far as P itself is known so well.
/// Where P is level, at a density of 0, any x of the level piece. None if u does not lie between P's values at the
/// ends, or P is NaN on the way.
/// @param P      T -> T, increasing from 0 to 1
/// @param range  finite
template <std::floating_point T, class Cdf>
[[nodiscard]] std::optional<Inversion<T>> invert_cdf(const Cdf& P, Interval<T> range, T u) {
    int        evaluations = 0;
    const auto x           = bracketed_root(
        [&](T t) {
            ++evaluations;
            return P(t) - u;
        },
        range);
    if (!x) return std::nullopt;
    return Inversion<T>{*x, evaluations};
}

}  // namespace sr
