#pragma once
/// @file horizon.hpp

#include <concepts>
#include <cstddef>
#include <vector>

#include "math/vector.hpp"

namespace sr {

/// The part of a polygon that a receiver in the origin with normal +z can get light from: that with z >= 0. Fewer than
/// three corners are left where there is none.
/// @see Sutherland and Hodgman, Reentrant Polygon Clipping, Comm. ACM 17 (1974)
template <std::floating_point T>
[[nodiscard]] std::vector<Vector3<T>> above_horizon(const std::vector<Vector3<T>>& polygon) {
    std::vector<Vector3<T>> above;
    above.reserve(polygon.size() + 1);  // of a convex one
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Vector3<T>& p = polygon[i];
        const Vector3<T>& q = polygon[(i + 1) % polygon.size()];
        if (p.z >= 0) above.push_back(p);
        if ((p.z > 0 && q.z < 0) || (p.z < 0 && q.z > 0)) {
            const T part = p.z / (p.z - q.z);  // between 0 and 1; and the new corner's z is 0, not nearly so
            above.push_back({p.x + part * (q.x - p.x), p.y + part * (q.y - p.y), 0});
        }
    }
    return above;
}

}  // namespace sr
