#pragma once
/// @file dual.hpp
/// Forward automatic differentiation: numbers that carry their derivatives along. How to use:
///     const auto f = surface.f(Dual<double>::variable(x, 0), Dual<double>::variable(y, 1),
///                              Dual<double>::variable(z, 2));
///     f.derivative;  // df/dx, df/dy, df/dz, as exact as if somebody had derived them by hand

#include <array>
#include <concepts>
#include <cstddef>

#include "math/square.hpp"

namespace sr {

/// a + b1 e1 + ... + bN eN with ei ej = 0, equation (2.12): a value, and its derivatives by N variables.
/// @tparam T  a floating-point type, or Interval of one: then derivatives are enclosed too
template <class T, std::size_t N = 3>
struct Dual {
    T                value;
    std::array<T, N> derivative;

    /// The variable with number i, where it is `value`.
    [[nodiscard]] static constexpr Dual variable(T value, std::size_t i) requires std::floating_point<T> {
        Dual result{value, {}};
        result.derivative[i] = T{1};
        return result;
    }

    friend constexpr Dual operator-(const Dual& a) {
        return linear(-a.value, a, [](T da) { return -da; });
    }
    friend constexpr Dual operator+(const Dual& a, const Dual& b) {
        return bilinear(a.value + b.value, a, b, [](T da, T db) { return da + db; });
    }
    friend constexpr Dual operator-(const Dual& a, const Dual& b) {
        return bilinear(a.value - b.value, a, b, [](T da, T db) { return da - db; });
    }
    friend constexpr Dual operator*(const Dual& a, const Dual& b) {
        return bilinear(a.value * b.value, a, b, [&](T da, T db) { return da * b.value + a.value * db; });
    }
    friend constexpr Dual operator/(const Dual& a, const Dual& b) {
        const T quotient = a.value / b.value;
        return bilinear(quotient, a, b, [&](T da, T db) { return (da - quotient * db) / b.value; });
    }
    friend constexpr Dual square(const Dual& a) {
        return linear(square(a.value), a, [&](T da) { return a.value * da + a.value * da; });
    }

    // With constants, whose derivatives are 0.
    template <std::floating_point K>
    friend constexpr Dual operator+(const Dual& a, K k) {
        return {a.value + k, a.derivative};
    }
    template <std::floating_point K>
    friend constexpr Dual operator-(const Dual& a, K k) {
        return {a.value - k, a.derivative};
    }
    template <std::floating_point K>
    friend constexpr Dual operator*(const Dual& a, K k) {
        return linear(a.value * k, a, [&](T da) { return da * k; });
    }
    template <std::floating_point K>
    friend constexpr Dual operator/(const Dual& a, K k) {
        return linear(a.value / k, a, [&](T da) { return da / k; });
    }
    template <std::floating_point K>
    friend constexpr Dual operator/(K k, const Dual& a) {
        const T quotient = k / a.value;
        return linear(quotient, a, [&](T da) { return -(quotient * da) / a.value; });
    }

private:
    template <class Derivative>
    static constexpr Dual linear(T value, const Dual& a, Derivative derivative) {
        Dual result{value, {}};
        for (std::size_t i = 0; i < N; ++i) result.derivative[i] = derivative(a.derivative[i]);
        return result;
    }
    template <class Derivative>
    static constexpr Dual bilinear(T value, const Dual& a, const Dual& b, Derivative derivative) {
        Dual result{value, {}};
        for (std::size_t i = 0; i < N; ++i)
            result.derivative[i] = derivative(a.derivative[i], b.derivative[i]);
        return result;
    }
};

}  // namespace sr
