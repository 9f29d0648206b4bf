#pragma once
/// @file quantity.hpp
/// Numbers whose unit is part of their type: what physics forbids does not compile. How to use:
///     const Radiance<double>   L{2};           // [W/(m^2 sr)]
///     const SolidAngle<double> seen{0.1};      // [sr]
///     const Irradiance<double> E = L * seen;   // [W/m^2]: products add the exponents of units
///     E + L;                                   // no: W/m^2 and W/(m^2 sr)
///     2.0 * L;                                 // a number scales it; 2 * L not, for 1 / 2 * L would be 0
///     E.value();                               // 0.2, a bare number
/// At run time nothing of it is left: a quantity is its value.

#include <compare>
#include <concepts>

#include "radiometry/spectrum.hpp"

namespace sr {

/// The exponents of a unit: W/(m^2 sr) is {.watt = 1, .metre = -2, .steradian = -1}.
///
/// The steradian is m^2/m^2, and to the SI therefore 1. Here it is kept, because without it irradiance and radiance
/// were of one type; `solid_angle_per_area` is where it comes from.
struct Unit {
    int watt = 0, metre = 0, steradian = 0, second = 0;

    friend constexpr bool operator==(const Unit&, const Unit&) = default;
    friend constexpr Unit operator*(const Unit& a, const Unit& b) {
        return {a.watt + b.watt, a.metre + b.metre, a.steradian + b.steradian, a.second + b.second};
    }
    friend constexpr Unit operator/(const Unit& a, const Unit& b) {
        return {a.watt - b.watt, a.metre - b.metre, a.steradian - b.steradian, a.second - b.second};
    }
};

/// A value in a unit.
/// @tparam V  a floating-point type, or a Spectrum of them
template <Unit U, class V>
class Quantity {
public:
    constexpr Quantity() = default;
    constexpr explicit Quantity(V value) : value_{value} {}

    [[nodiscard]] constexpr const V& value() const { return value_; }

    friend constexpr Quantity operator+(const Quantity& a, const Quantity& b) {
        return Quantity{a.value_ + b.value_};
    }
    friend constexpr Quantity operator-(const Quantity& a, const Quantity& b) {
        return Quantity{a.value_ - b.value_};
    }
    friend constexpr bool operator==(const Quantity&, const Quantity&) = default;
    friend constexpr auto operator<=>(const Quantity&, const Quantity&) requires std::three_way_comparable<V>
    = default;

private:
    V value_{};
};

/// What a value is made of: a Spectrum of floats.
template <class V>
struct ScalarOf {
    using type = V;
};
template <std::floating_point T>
struct ScalarOf<BasicSpectrum<T>> {
    using type = T;
};

/// Values that may be multiplied: both of floats or both of doubles, so that none becomes another type unasked. A
/// quantity is none, nor is a whole number: 1 / 2 * L would be 0 * L.
template <class V, class X>
concept Multipliable =
    std::floating_point<typename ScalarOf<V>::type> && std::same_as < typename ScalarOf<V>::type,
typename ScalarOf<X>::type > ;
/// And divided, which is by a number, never by a colour.
template <class V, class X>
concept Divisible = std::floating_point<X> && Multipliable<V, X>;

/// The value in its unit; where units have cancelled, the bare value.
template <Unit U, class V>
[[nodiscard]] constexpr auto in_unit(V value) {
    if constexpr (U == Unit{})
        return value;
    else
        return Quantity<U, V>{value};
}

/// The exponents add up.
template <Unit U, class V, Unit W, class X>
requires Multipliable<V, X>
[[nodiscard]] constexpr auto operator*(const Quantity<U, V>& a, const Quantity<W, X>& b) {
    return in_unit<U * W>(a.value() * b.value());
}
template <Unit U, class V, Unit W, class X>
requires Divisible<V, X>
[[nodiscard]] constexpr auto operator/(const Quantity<U, V>& a, const Quantity<W, X>& b) {
    return in_unit<U / W>(a.value() / b.value());
}

// A value without a unit has exponents of 0.
template <class K, Unit U, class V>
requires Multipliable<K, V>
[[nodiscard]] constexpr auto operator*(const K& k, const Quantity<U, V>& q) {
    return in_unit<U>(k * q.value());
}
template <Unit U, class V, class K>
requires Multipliable<V, K>
[[nodiscard]] constexpr auto operator*(const Quantity<U, V>& q, const K& k) {
    return in_unit<U>(q.value() * k);
}
template <Unit U, class V, class K>
requires Divisible<V, K>
[[nodiscard]] constexpr auto operator/(const Quantity<U, V>& q, const K& k) {
    return in_unit<U>(q.value() / k);
}
template <class K, Unit U, class V>
requires Divisible<K, V>
[[nodiscard]] constexpr auto operator/(const K& k, const Quantity<U, V>& q) {
    return in_unit<Unit{} / U>(k / q.value());
}

template <class V>
using Length = Quantity<Unit{.metre = 1}, V>;  ///< [m]
template <class V>
using Area = Quantity<Unit{.metre = 2}, V>;  ///< [m^2]
template <class V>
using SolidAngle = Quantity<Unit{.steradian = 1}, V>;  ///< [sr]
template <class V>
using Time = Quantity<Unit{.second = 1}, V>;  ///< [s]
template <class V>
using Rate = Quantity<Unit{.second = -1}, V>;  ///< [1/s], such as photons per time
template <class V>
using Energy = Quantity<Unit{.watt = 1, .second = 1}, V>;  ///< [J]
template <class V>
using Flux = Quantity<Unit{.watt = 1}, V>;  ///< energy per time [W]
template <class V>
using Intensity = Quantity<Unit{.watt = 1, .steradian = -1}, V>;  ///< flux per solid angle [W/sr]
template <class V>
using Irradiance = Quantity<Unit{.watt = 1, .metre = -2}, V>;  ///< flux that arrives, per area [W/m^2]
template <class V>
using Radiosity = Irradiance<V>;  ///< flux that leaves, per area [W/m^2]
template <class V>
using Radiance = Quantity<Unit{.watt = 1, .metre = -2, .steradian = -1}, V>;  ///< [W/(m^2 sr)]

}  // namespace sr
