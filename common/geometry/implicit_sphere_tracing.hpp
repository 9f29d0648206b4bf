#pragma once
/// @file implicit_sphere_tracing.hpp

#include <algorithm>
#include <cmath>
#include <concepts>
#include <limits>
#include <optional>

#include "geometry/implicit_surface.hpp"

namespace sr {

/// A number that |grad f| nowhere in the box exceeds. Intervals of the gradient bound it in each of 16^3 cells,
/// more tightly than in the box as a whole; once for a surface, not once for a ray.
template <std::floating_point T, ImplicitSurface<T> Surface>
[[nodiscard]] T lipschitz_bound(const Surface& surface, const Box<T>& box) {
    constexpr int cells = 16;
    using Number        = Dual<Interval<T>, 3>;
    const auto cell     = [&](int axis, int i) {
        const T side = box.max[axis] - box.min[axis];
        return Interval<T>{box.min[axis] + side * T(i) / cells, box.min[axis] + side * T(i + 1) / cells};
    };
    constexpr Interval<T> zero{0, 0}, one{1, 1};
    T                     largest = 0;
    for (int i = 0; i < cells * cells * cells; ++i) {
        const auto f  = surface.f(Number{cell(0, i % cells), {one, zero, zero}},
                                  Number{cell(1, i / cells % cells), {zero, one, zero}},
                                  Number{cell(2, i / cells / cells), {zero, zero, one}});
        const auto g2 = square(f.derivative[0]) + square(f.derivative[1]) + square(f.derivative[2]);
        largest       = std::max(largest, g2.max);
    }
    return rounded_up(std::sqrt(largest));
}

/// The first root of f(o + t d) in `range`, by steps that can't go through the surface: if |grad f| <= L, the
/// sphere of radius |f(p)| / L around p holds no root, equation (2.8).
/// @param lipschitz  L, see lipschitz_bound; where it is too small, the ray may pass through the surface
/// @param tolerance  in units of t: nearer, the surface counts as hit. A ray that passes it nearer than that is hit
///                   wrongly; one that grazes it gives up after 4096 steps.
/// @pre   tolerance >= 0, range.min >= 0; the ray starts farther from the surface than the tolerance. One that leaves
///        this surface does not, and is hit where it starts. It may be traced with a tolerance of 0, from where `leave`
///        has it start, and if it grazes the surface gives up; `solve` loses none
/// @see   implicit_offset.hpp
/// @see   Hart, Sphere Tracing, The Visual Computer 12 (1996)
template <std::floating_point T, ImplicitSurface<T> Surface>
[[nodiscard]] std::optional<T> sphere_trace(const Surface& surface, const Ray<T>& ray, Interval<T> range,
                                            T lipschitz, T tolerance) {
    const auto part = within_bounds(surface, ray, range);
    if (!part) return std::nullopt;
    constexpr int max_steps = 4096;
    const T       slope     = lipschitz * length(ray.direction);  // |df/dt| is no larger
    const T       least     = std::max(tolerance, part->max * std::numeric_limits<T>::epsilon());
    T             t         = part->min;
    for (int i = 0; i < max_steps && t <= part->max; ++i) {
        const T safe = std::abs(on_ray(surface, ray, t)) / slope;
        if (safe <= least) return t;
        t += safe;  // NaN ends the loop
    }
    return std::nullopt;
}

}  // namespace sr
