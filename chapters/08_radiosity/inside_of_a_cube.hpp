#pragma once
/// @file inside_of_a_cube.hpp

#include <vector>

#include "radiosity/polygons.hpp"

namespace sr {

/// The six faces -x, +x, -y, +y, -z, +z of a box with these sides, black, with their fronts to the inside.
[[nodiscard]] inline std::vector<Polygon> inside_of_a_box(const Vector3<double>& sides) {
    using Point = Vector3<double>;
    std::vector<Polygon> faces;
    for (int axis = 0; axis < 3; ++axis) {
        for (const double at : {0.0, 1.0}) {
            const auto corner = [&](double u, double v) {
                Point p;
                p[axis]           = at;
                p[(axis + 1) % 3] = u;
                p[(axis + 2) % 3] = v;
                return p * sides;
            };
            const Patch face{corner(0, 0), corner(1, 0), corner(1, 1),
                             corner(0, 1)};  // its normal is along +axis
            faces.push_back({at == 0 ? face : face.reversed(), {}, {}, 0});
        }
    }
    return faces;
}

[[nodiscard]] inline std::vector<Polygon> inside_of_a_cube() {
    return inside_of_a_box({1, 1, 1});
}

}  // namespace sr
