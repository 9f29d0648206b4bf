#pragma once
/// @file implicit_closed_form.hpp

#include <algorithm>
#include <cmath>
#include <concepts>
#include <optional>

#include "geometry/implicit_surface.hpp"
#include "math/polynomial.hpp"
#include "math/polynomial_roots.hpp"

namespace sr {

/// A surface whose f is a polynomial.
template <class Surface, class T>
concept AlgebraicSurface = ImplicitSurface<Surface, T> &&
    requires(const Surface surface, Polynomial<T, 1> t) {
    surface.f(t, t, t);
};

/// The first root of f(o + t d) in `range`, as the first root of a polynomial in t: a quadratic for ellipsoid and
/// hyperboloid, a quartic for torus and tanglecube.
///
/// The coefficients are those of the ray as seen from the middle of the surface's bounds and with a direction of
/// length about 1: seen from a distance D, those of a quartic grow with D^4, and the digits of the roots go.
/// @pre range.min >= 0
template <std::floating_point T, AlgebraicSurface<T> Surface>
[[nodiscard]] std::optional<T> solve(const Surface& surface, const Ray<T>& ray,
                                     Interval<T> range = in_front<T>) {
    const auto part = within_bounds(surface, ray, range);
    if (!part) return std::nullopt;
    const T    middle = part->min / 2 + part->max / 2;
    const auto size   = glm::abs(ray.direction);
    const T    scale  = std::max(size.x, std::max(size.y, size.z));
    const auto d      = ray.direction / scale;
    const auto o      = ray.at(middle);

    const auto f =
        surface.f(Polynomial<T, 1>{{o.x, d.x}}, Polynomial<T, 1>{{o.y, d.y}}, Polynomial<T, 1>{{o.z, d.z}});
    const auto root = first_root(f, {(part->min - middle) * scale, (part->max - middle) * scale});
    if (!root) return std::nullopt;
    return std::clamp(middle + *root / scale, part->min, part->max);
}

}  // namespace sr
