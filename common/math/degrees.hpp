#pragma once
/// @file degrees.hpp

#include <numbers>

namespace sr {

/// An angle [rad] from degrees.
[[nodiscard]] constexpr double radians(double degrees) {
    return degrees * std::numbers::pi / 180;
}

/// An angle [deg] from radians.
[[nodiscard]] constexpr double degrees(double radians) {
    return radians * 180 / std::numbers::pi;
}

}  // namespace sr
