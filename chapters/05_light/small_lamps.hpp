#pragma once
/// @file small_lamps.hpp
/// What rounding leaves of small solid angles in float, by the textbook's forms and by those of the core.

#include <algorithm>
#include <cmath>

#include "geometry/sphere.hpp"
#include "geometry/triangle.hpp"
#include "math/extremes.hpp"
#include "radiometry/polygon_solid_angle.hpp"
#include "radiometry/solid_angle.hpp"
#include "textbook_solid_angles.hpp"

namespace sr {

/// The worst relative error of `in_float(size)` among 64 sizes within 10 % of this one, against `exact(size)`.
template <class InFloat, class Exact>
[[nodiscard]] double worst_relative_error(double size, const InFloat& in_float, const Exact& exact) {
    double worst = 0;
    for (int i = 0; i < 64; ++i) {
        const auto   s     = float(size * (1 + i / 640.0));
        const double truth = exact(double(s));
        worst              = max_or_nan(worst, std::abs(double(in_float(s)) - truth) / truth);
    }
    return worst;
}

/// A right triangle with legs of this length at the distance 1.
template <std::floating_point T>
[[nodiscard]] Triangle<T> small_triangle(T legs) {
    return {{0, 0, 1}, {legs, 0, 1}, {0, legs, 1}};
}

/// A sphere that is seen at the distance 1.
template <std::floating_point T>
[[nodiscard]] Sphere<T> small_sphere(T radius) {
    return {{0, 0, 1}, radius};
}

[[nodiscard]] inline double exact_sphere(double radius) {
    return solid_angle(small_sphere(radius)).value();
}
[[nodiscard]] inline double exact_triangle(double legs) {
    return solid_angle(small_triangle(legs)).value();
}

}  // namespace sr
