#pragma once
/// @file polygons.hpp
/// Polygons that tests look at from the origin.

#include <vector>

#include "math/vector.hpp"

namespace sr::test {

using Points = std::vector<Vector3<double>>;

/// The points (x, y, z) between x0 and x1, y0 and y1.
[[nodiscard]] inline Points rectangle(double x0, double x1, double y0, double y1, double z) {
    return {{x0, y0, z}, {x1, y0, z}, {x1, y1, z}, {x0, y1, z}};
}

}  // namespace sr::test
