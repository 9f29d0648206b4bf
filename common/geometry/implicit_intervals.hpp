#pragma once
/// @file implicit_intervals.hpp

#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <limits>
#include <optional>

#include "geometry/implicit_surface.hpp"
#include "math/bracketed_root.hpp"

namespace sr {

/// What intervals prove of a piece of a ray.
enum class Proof { no_root, one_root, nothing };

/// If the bounds of f hold no 0, there is no root. If those of df/dt hold none, f rises or falls all along, and its
/// signs at the two ends tell whether there is one, unless rounding leaves them open.
template <std::floating_point T, ImplicitSurface<T> Surface>
[[nodiscard]] Proof prove(const Surface& surface, const Ray<T>& ray, Interval<T> piece) {
    if (!on_ray(surface, ray, piece).contains(0)) return Proof::no_root;
    if (bounds_on_ray(surface, ray, piece).derivative[0].contains(0)) return Proof::nothing;
    const auto begin = on_ray(surface, ray, Interval<T>{piece.min, piece.min});
    const auto end   = on_ray(surface, ray, Interval<T>{piece.max, piece.max});
    if (begin.contains(0) || end.contains(0)) return Proof::nothing;
    return (begin.max < 0) == (end.max < 0) ? Proof::no_root : Proof::one_root;
}

/// The first root of f(o + t d) in `range` by interval arithmetic. Pieces of the ray of which nothing is proved are
/// halved, the nearer half first, equation (2.9). No root is missed, simple or not, whatever the rounding: what is
/// left in doubt at the least width counts as one, and so does the first place in doubt after 65536 pieces. A place
/// where f is infinite or no number is no root.
/// @param width  in units of t, at which a piece in doubt is taken for a root: where the ray grazes the surface, or
///               passes it so near that rounding does not tell
/// @pre   width >= 0, range.min >= 0
/// @see   Mitchell, Robust Ray Intersection with Interval Arithmetic, Graphics Interface 1990
template <std::floating_point T, ImplicitSurface<T> Surface>
[[nodiscard]] std::optional<T> bisect_intervals(const Surface& surface, const Ray<T>& ray, Interval<T> range,
                                                T width) {
    const auto part = within_bounds(surface, ray, range);
    if (!part) return std::nullopt;
    const auto f     = [&](T t) { return on_ray(surface, ray, t); };
    const T    least = std::max(width, 2 * part->max * std::numeric_limits<T>::epsilon());

    constexpr int                                               max_pieces = 65536;
    std::array<Interval<T>, std::numeric_limits<T>::digits + 2> waiting;
    std::size_t                                                 count = 0;
    waiting[count++]                                                  = *part;
    for (int i = 0; count > 0 && i < max_pieces; ++i) {
        const Interval<T> piece = waiting[--count];
        const Proof       proof = prove(surface, ray, piece);
        if (proof == Proof::no_root) continue;
        if (proof == Proof::one_root) return bracketed_root(f, piece);
        const T middle = piece.min / 2 + piece.max / 2;
        if (piece.max - piece.min > least) {
            waiting[count++] = {middle, piece.max};
            waiting[count++] = {piece.min, middle};
        } else if (std::isfinite(f(middle))) {
            return middle;
        }
    }
    // Up to here it is proved that there is no root, and beyond nobody has looked.
    if (count > 0 && std::isfinite(f(waiting[count - 1].min))) return waiting[count - 1].min;
    return std::nullopt;
}

}  // namespace sr
