#pragma once
/// @file disk.hpp

#include <concepts>

#include "math/vector.hpp"

namespace sr {

/// The points of a plane within `radius` of the centre, [length unit].
/// @pre |normal| = 1
template <std::floating_point T>
struct Disk {
    Vector3<T> centre;
    Vector3<T> normal;
    T          radius;
};

}  // namespace sr
