#pragma once
/// @file implicit_marching.hpp

#include <concepts>
#include <optional>

#include "geometry/implicit_surface.hpp"
#include "math/bracketed_root.hpp"

namespace sr {

/// A root of f(o + t d) in `range` by steps of fixed length: where f changes its sign from one step to the next,
/// a root is between them. It is the first if no two roots lie between neighbouring steps: what is thinner than a
/// step may be missed, equation (2.7), and what only touches the ray always is.
///
/// A value counts as inside if it is negative and as outside if not, so that a step which ends on the surface is
/// one of the two; with f f < 0 such a root is lost, since neither interval beside it changes the sign.
/// @param step  in units of t; no more than 65536 steps are made
/// @pre   step > 0; range.min >= 0, and large enough, where the ray starts on the surface, that it has left it by
///        more than rounding
template <std::floating_point T, ImplicitSurface<T> Surface>
[[nodiscard]] std::optional<T> march(const Surface& surface, const Ray<T>& ray, Interval<T> range, T step) {
    const auto part = within_bounds(surface, ray, range);
    if (!part) return std::nullopt;
    constexpr int max_steps = 65536;
    const T       span      = part->max - part->min;
    const int     steps     = span < T(max_steps) * step ? int(span / step) + 1 : max_steps;
    const T       length    = span < T(max_steps) * step ? step : span / max_steps;

    const auto f    = [&](T t) { return on_ray(surface, ray, t); };
    T          from = part->min, at_from = f(from);
    for (int i = 1; i <= steps; ++i) {
        // Not the last point plus a step: where t is large, a float plus a small step is the same float.
        const T to    = i == steps ? part->max : part->min + T(i) * length;
        const T at_to = f(to);
        if ((at_from < 0) != (at_to < 0)) {
            if (const auto root = bracketed_root(f, Interval<T>{from, to})) return root;
        }
        from    = to;
        at_from = at_to;
    }
    return std::nullopt;
}

}  // namespace sr
