#pragma once
/// @file loose_bounds.hpp

#include <concepts>

#include "geometry/box.hpp"

namespace sr {

/// A surface in a box so large that it does not tell where in it the surface is: what any scene with more than one
/// surface in it is like.
template <class Surface, std::floating_point T>
struct LooseBounds : Surface {
    T half_side;

    [[nodiscard]] Box<T> bounds() const { return {Vector3<T>(-half_side), Vector3<T>(half_side)}; }
};

}  // namespace sr
