#pragma once
/// @file implicit_normal.hpp

#include <concepts>

#include "geometry/implicit_surface.hpp"
#include "math/unit.hpp"
#include "math/vector.hpp"

namespace sr {

/// The unit normal at a point p of the surface, grad f / |grad f|, equation (2.11): it points out of it. Where the
/// gradient is 0, at a cone's apex, there is none, and what stands in its place faces the viewer; where f is a
/// square, that is everywhere, and nothing but another f helps.
/// @param d  the direction in which p is seen
/// @pre   d is finite and not 0
template <class Surface, std::floating_point T>
[[nodiscard]] Vector3<T> normal(const Surface& surface, Vector3<T> p, Vector3<T> d) {
    return unit(gradient(surface, p)).value_or(-normalize(d));
}

}  // namespace sr
