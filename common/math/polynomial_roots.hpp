#pragma once
/// @file polynomial_roots.hpp
/// Real roots of a polynomial in an interval. Between two neighbouring roots of its derivative a polynomial rises or
/// falls, and has one root or none, which a bracket holds; the derivative's roots are found in the same way.
///
/// There is a formula for the quartic, Ferrari's. Of rays that are level with a torus it gets one in eight wrong, in
/// double as in float: their quartics are even about a point, and there it divides by what should be 0.
/// @see Yuksel, High-Performance Polynomial Root Finding for Graphics, HPG 2022

#include <array>
#include <concepts>
#include <cstddef>
#include <limits>
#include <optional>

#include "math/bracketed_root.hpp"
#include "math/interval.hpp"
#include "math/polynomial.hpp"
#include "math/quadratic.hpp"

namespace sr {

/// Up to N roots in ascending order.
template <std::floating_point T, std::size_t N>
struct RootList {
    std::array<T, N> root{};
    std::size_t      count = 0;

    /// A root where two pieces meet is found in both.
    void add(T t) {
        if (count == 0 || root[count - 1] < t) root[count++] = t;
    }
    [[nodiscard]] constexpr auto begin() const { return root.begin(); }
    [[nodiscard]] constexpr auto end() const { return root.begin() + std::ptrdiff_t(count); }
};

template <std::floating_point T, std::size_t N>
[[nodiscard]] RootList<T, N> roots_in(const Polynomial<T, N>& p, Interval<T> range, std::size_t at_most = N);

/// The least root in the range.
template <std::floating_point T, std::size_t N>
[[nodiscard]] std::optional<T> first_root(const Polynomial<T, N>& p, Interval<T> range) {
    const auto roots = roots_in(p, range, 1);
    if (roots.count == 0) return std::nullopt;
    return roots.root[0];
}

/// Both roots of a quadratic, as far as they lie in the range.
template <std::floating_point T>
[[nodiscard]] RootList<T, 2> roots_in(const Polynomial<T, 2>& p, Interval<T> range, std::size_t at_most = 2) {
    RootList<T, 2> result;
    const auto     roots = quadratic_roots(p.c[2], p.c[1] / 2, p.c[0]);
    if (!roots) return result;
    if (range.contains(roots->first)) result.add(roots->first);
    if (result.count < at_most && range.contains(roots->second)) result.add(roots->second);
    return result;
}

/// The first roots in the range, ascending; a root of even order, where the polynomial only touches 0 within its
/// rounding errors, once.
/// @pre the range is finite
template <std::floating_point T, std::size_t N>
[[nodiscard]] RootList<T, N> roots_in(const Polynomial<T, N>& p, Interval<T> range, std::size_t at_most) {
    static_assert(N > 2);
    constexpr T rounding = 4 * T(N) * std::numeric_limits<T>::epsilon();
    const auto  critical = roots_in(p.derivative(), range);

    RootList<T, N> result;
    Interval<T>    piece{range.min, range.min};
    bool           touches = false;  // 0 at the piece's first end
    for (std::size_t i = 0; i <= critical.count && result.count < at_most; ++i) {
        piece           = {piece.max, i < critical.count ? critical.root[i] : range.max};
        const auto root = bracketed_root(p, piece);
        if (root) {
            result.add(*root);
        } else if (touches) {
            result.add(piece.min);
        }
        const bool extremum = i < critical.count;
        touches = !root && extremum && std::abs(p(piece.max)) <= rounding * p.magnitude(piece.max);
    }
    return result;
}

}  // namespace sr
