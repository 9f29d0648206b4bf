#pragma once
/// @file interval.hpp
/// A closed interval [min, max] of the real line, the form of every "nearest t >= eps" of the course.

#include <concepts>
#include <limits>

namespace sr {

template <std::floating_point T>
struct Interval {
    T min = 0;
    T max = std::numeric_limits<T>::infinity();

    /// False for NaN and for infinity, so that a hit is at a number, whatever has overflowed.
    [[nodiscard]] constexpr bool contains(T t) const {
        constexpr T largest = std::numeric_limits<T>::max();
        return min <= t && t <= max && -largest <= t && t <= largest;
    }
    [[nodiscard]] constexpr bool empty() const { return !(min <= max); }
};

/// The t that a ray may hit at: everything in front of its origin.
template <std::floating_point T>
inline constexpr Interval<T> in_front{};

}  // namespace sr
