#pragma once
/// @file polynomial.hpp
/// Polynomials in one variable as a number type: a formula that is evaluated with o + t d in place of x expands
/// itself into the coefficients of a polynomial in t.

#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>
#include <cstddef>

#include "math/square.hpp"

namespace sr {

/// c[0] + c[1] t + ... + c[N] t^N.
template <std::floating_point T, std::size_t N>
struct Polynomial {
    std::array<T, N + 1> c{};

    /// By Horner's rule.
    [[nodiscard]] constexpr T operator()(T t) const {
        T sum = c[N];
        for (std::size_t i = N; i-- > 0;) sum = sum * t + c[i];
        return sum;
    }

    /// |c[0]| + |c[1] t| + ...: what the rounding errors of the value at t are a few units in the last place of.
    [[nodiscard]] constexpr T magnitude(T t) const {
        T sum = std::abs(c[N]);
        for (std::size_t i = N; i-- > 0;) sum = sum * std::abs(t) + std::abs(c[i]);
        return sum;
    }

    [[nodiscard]] constexpr auto derivative() const requires(N > 0) {
        Polynomial<T, N - 1> result;
        for (std::size_t i = 1; i <= N; ++i) result.c[i - 1] = T(i) * c[i];
        return result;
    }

    friend constexpr Polynomial operator+(Polynomial a, T k) {
        a.c[0] += k;
        return a;
    }
    friend constexpr Polynomial operator-(Polynomial a, T k) { return a + -k; }
    friend constexpr Polynomial operator*(Polynomial a, T k) {
        for (T& coefficient : a.c) coefficient *= k;
        return a;
    }
    friend constexpr Polynomial operator/(Polynomial a, T k) {
        for (T& coefficient : a.c) coefficient /= k;
        return a;
    }
};

template <std::floating_point T, std::size_t N, std::size_t M>
[[nodiscard]] constexpr auto operator+(const Polynomial<T, N>& a, const Polynomial<T, M>& b) {
    Polynomial<T, std::max(N, M)> sum;
    for (std::size_t i = 0; i <= N; ++i) sum.c[i] = a.c[i];
    for (std::size_t i = 0; i <= M; ++i) sum.c[i] += b.c[i];
    return sum;
}

template <std::floating_point T, std::size_t N, std::size_t M>
[[nodiscard]] constexpr auto operator-(const Polynomial<T, N>& a, const Polynomial<T, M>& b) {
    return a + b * T{-1};
}

template <std::floating_point T, std::size_t N, std::size_t M>
[[nodiscard]] constexpr auto operator*(const Polynomial<T, N>& a, const Polynomial<T, M>& b) {
    Polynomial<T, N + M> product;
    for (std::size_t i = 0; i <= N; ++i) {
        for (std::size_t j = 0; j <= M; ++j) product.c[i + j] += a.c[i] * b.c[j];
    }
    return product;
}

template <std::floating_point T, std::size_t N>
[[nodiscard]] constexpr auto square(const Polynomial<T, N>& a) {
    return a * a;
}

}  // namespace sr
