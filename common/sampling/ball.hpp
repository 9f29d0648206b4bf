#pragma once
/// @file ball.hpp

#include <concepts>

#include "math/vector.hpp"
#include "sampling/rng.hpp"

namespace sr {

/// A point of the unit ball, each as likely, by rejection: about two tries. Normalised, a direction of the
/// sphere; points too near the centre to be that are rejected, too.
template <std::floating_point T>
[[nodiscard]] Vector3<T> in_unit_ball(Rng& rng) {
    for (;;) {
        const T          x = rng.uniform<T>(), y = rng.uniform<T>(), z = rng.uniform<T>();
        const Vector3<T> p{2 * x - 1, 2 * y - 1, 2 * z - 1};
        const T          squared = dot(p, p);
        if (squared <= 1 && squared > T(1e-4)) return p;
    }
}

}  // namespace sr
