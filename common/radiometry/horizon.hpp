#pragma once
/// @file horizon.hpp

#include <concepts>
#include <cstddef>
#include <span>

#include "math/vector.hpp"

namespace sr {

/// Calls corner(p) for each corner of the part of a polygon that a receiver in the origin with normal +z can get light
/// from: that with z >= 0. There are fewer than three where there is no such part, and of a convex one at most one
/// more than it had. Nothing is stored: form factors are summed up of this.
/// @see Sutherland and Hodgman, Reentrant Polygon Clipping, Comm. ACM 17 (1974)
template <std::floating_point T>
void corners_above_horizon(std::span<const Vector3<T>> polygon, auto&& corner) {
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Vector3<T>& p = polygon[i];
        const Vector3<T>& q = polygon[i + 1 < polygon.size() ? i + 1 : 0];
        if (p.z >= 0) corner(p);
        if ((p.z > 0 && q.z < 0) || (p.z < 0 && q.z > 0)) {
            const T part = p.z / (p.z - q.z);  // between 0 and 1; and the new corner's z is 0, not nearly so
            corner(Vector3<T>{p.x + part * (q.x - p.x), p.y + part * (q.y - p.y), 0});
        }
    }
}

}  // namespace sr
