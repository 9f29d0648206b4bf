#pragma once
/// @file differences.hpp

#include <concepts>

#include "math/vector.hpp"

namespace sr {

/// The gradient of f by central differences, equation (2.13), for whoever knows nothing of f but its values.
template <class Surface, std::floating_point T>
[[nodiscard]] Vector3<T> gradient_by_differences(const Surface& surface, Vector3<T> p, T h) {
    return Vector3<T>{surface.f(p.x + h, p.y, p.z) - surface.f(p.x - h, p.y, p.z),
                      surface.f(p.x, p.y + h, p.z) - surface.f(p.x, p.y - h, p.z),
                      surface.f(p.x, p.y, p.z + h) - surface.f(p.x, p.y, p.z - h)} /
           (2 * h);
}

}  // namespace sr
