#pragma once
/// @file fan.hpp

#include <algorithm>
#include <cstddef>
#include <optional>
#include <span>

#include "math/vector.hpp"

namespace sr {

/// The first corner k from which the fan of triangles (k, k+1, k+2), (k, k+2, k+3), ... is the polygon: none of them is
/// turned over against the whole, by more than rounding. That of a convex polygon is corner 0; of a dart it is the tip
/// inside; and from no corner of some polygons is all of them seen.
[[nodiscard]] inline std::optional<std::size_t> fan_corner(std::span<const Vector3<double>> polygon) {
    const std::size_t n          = polygon.size();
    const auto        at         = [&](std::size_t i) { return polygon[i % n]; };
    const auto        twice_area = [&](std::size_t k, std::size_t i) {
        return cross(at(i) - at(k), at(i + 1) - at(k));
    };

    Vector3<double> whole{};
    for (std::size_t i = 1; i + 1 < n; ++i) whole += twice_area(0, i);
    const double rounding = 1e-6 * dot(whole, whole);  // files hold six digits
    for (std::size_t k = 0; k < n; ++k) {
        bool turned_over = false;
        for (std::size_t i = k + 1; i + 1 < k + n && !turned_over; ++i)
            turned_over = dot(twice_area(k, i), whole) < -rounding;
        if (!turned_over) return k;
    }
    return std::nullopt;
}

}  // namespace sr
