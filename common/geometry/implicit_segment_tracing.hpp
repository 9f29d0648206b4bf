#pragma once
/// @file implicit_segment_tracing.hpp

#include <algorithm>
#include <cmath>
#include <concepts>
#include <limits>
#include <optional>

#include "geometry/implicit_surface.hpp"
#include "math/bracketed_root.hpp"

namespace sr {

/// The first root of f(o + t d) in `range`, as sphere tracing finds it, with a bound of |df/dt| for the piece of
/// the ray ahead instead of one for the whole surface: intervals give it anew at each step. Steps are fewer, dearer
/// each, and no constant need be known.
/// @param tolerance  in units of t, as of sphere tracing; a ray that grazes the surface gives up after 4096 steps
/// @pre   tolerance >= 0, range.min >= 0; the ray starts farther from the surface than the tolerance, as
///        sphere_trace says: `solve` finds what rays that leave the surface meet
/// @see   Galin et al., Segment Tracing Using Local Lipschitz Bounds, Computer Graphics Forum 39(2), 2020
template <std::floating_point T, ImplicitSurface<T> Surface>
[[nodiscard]] std::optional<T> segment_trace(const Surface& surface, const Ray<T>& ray, Interval<T> range,
                                             T tolerance) {
    const auto part = within_bounds(surface, ray, range);
    if (!part) return std::nullopt;
    constexpr int max_steps = 4096;
    const T       least     = std::max(tolerance, part->max * std::numeric_limits<T>::epsilon());
    const auto    f         = [&](T t) { return on_ray(surface, ray, t); };
    T             t         = part->min;
    T             value = f(t), reach = part->max - part->min;
    for (int i = 0; i < max_steps; ++i) {
        const Interval<T> ahead{t, std::min(t + reach, part->max)};
        const T           slope = magnitude(bounds_on_ray(surface, ray, ahead).derivative[0]);
        const T           safe  = std::abs(value) / slope;
        if (safe > least || t + safe > ahead.max) {
            const bool empty  = t + safe > ahead.max;  // nothing on the whole piece
            const T    before = t;
            t                 = empty ? ahead.max : t + safe;
            reach             = 2 * (empty ? reach : safe);
            // Near the surface the step may have relied on nothing but the rounding error of f.
            const T here = f(t);
            if (opposite_signs(value, here)) return bracketed_root(f, Interval<T>{before, t});
            if (t >= part->max) return std::nullopt;
            value = here;
        } else if (reach > 4 * least) {
            reach /= 4;  // it may be the bound that is too large, not the surface that is near
        } else if (safe <= least) {
            return t;
        } else {
            return std::nullopt;  // NaN
        }
    }
    return std::nullopt;
}

}  // namespace sr
