#pragma once
/// @file frame.hpp

#include <cmath>
#include <concepts>

#include "math/vector.hpp"

namespace sr {

/// A right-handed orthonormal frame; a local direction (x, y, z) stands for x s + y t + z n.
template <std::floating_point T>
struct Frame {
    Vector3<T> s;
    Vector3<T> t;
    Vector3<T> n;

    [[nodiscard]] constexpr Vector3<T> to_world(Vector3<T> local) const {
        return local.x * s + local.y * t + local.z * n;
    }
    [[nodiscard]] constexpr Vector3<T> to_local(Vector3<T> world) const {
        return {dot(world, s), dot(world, t), dot(world, n)};
    }
};

/// A frame around the unit vector n, without a branch and without a direction in which it fails. (Frisvad's
/// form divides by 1 + n.z and is off by 0.2 near n = -z in float.)
/// @pre |n| = 1
/// @see Duff et al., Building an Orthonormal Basis, Revisited, JCGT 6(1), 2017
template <std::floating_point T>
[[nodiscard]] Frame<T> frame_around(Vector3<T> n) {
    const T sign = std::copysign(T{1}, n.z);
    const T a    = T{-1} / (sign + n.z);
    const T b    = n.x * n.y * a;
    return {{1 + sign * n.x * n.x * a, sign * b, -sign * n.x}, {b, sign + n.y * n.y * a, -n.y}, n};
}

}  // namespace sr
