#pragma once
/// @file implicit_segment_tracing.hpp

#include <algorithm>
#include <cmath>
#include <concepts>
#include <limits>
#include <optional>

#include "geometry/implicit_surface.hpp"

namespace sr {

/// The first root of f(o + t d) in `range`, as sphere tracing finds it, with a bound of |df/dt| for the piece of the
/// ray ahead instead of one for the whole surface: intervals give it anew at each step. Steps are fewer, dearer
/// each, and no constant need be known.
/// @param tolerance  in units of t, as of sphere tracing
/// @pre   range.min >= 0; the ray starts farther from the surface than the tolerance
/// @see   Galin et al., Segment Tracing Using Local Lipschitz Bounds, Computer Graphics Forum 39(2), 2020
template <std::floating_point T, ImplicitSurface<T> Surface>
[[nodiscard]] std::optional<T> segment_trace(const Surface& surface, const Ray<T>& ray, Interval<T> range,
                                             T tolerance) {
    const auto part = within_bounds(surface, ray, range);
    if (!part) return std::nullopt;
    constexpr int max_steps = 4096;
    const T       least     = std::max(tolerance, part->max * std::numeric_limits<T>::epsilon());
    T             t         = part->min;
    T             reach     = part->max - part->min;
    for (int i = 0; i < max_steps; ++i) {
        const Interval<T> ahead{t, std::min(t + reach, part->max)};
        const T           slope = magnitude(bounds_on_ray(surface, ray, ahead).derivative[0]);
        const T           safe  = std::abs(on_ray(surface, ray, t)) / slope;
        if (t + safe > ahead.max) {  // nothing on the piece
            if (ahead.max >= part->max) return std::nullopt;
            t = ahead.max;
            reach *= 2;
        } else if (safe > least) {
            t += safe;
            reach = 2 * safe;
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
