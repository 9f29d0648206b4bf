#pragma once
/// @file small_area.hpp
/// How good is A cos / r^2 for an area that is not small? Equation (5.5) against closed forms.

#include <cmath>
#include <numbers>

#include "geometry/disk.hpp"
#include "math/square.hpp"
#include "radiometry/disk_solid_angle.hpp"
#include "radiometry/projected_solid_angle.hpp"
#include "radiometry/solid_angle.hpp"

namespace sr {

/// The relative error of A cos / r^2 for the solid angle of a disk at the distance 1.
/// @param tilt  between the disk's normal and the line of sight [rad]
[[nodiscard]] inline double small_disk_error(double radius, double tilt) {
    const double about =
        std::numbers::pi * square(radius) * solid_angle_per_area(std::cos(tilt), Length<double>{1}).value();
    const Disk<double> disk{{0, 0, 1}, {std::sin(tilt), 0, std::cos(tilt)}, radius};
    return std::abs(about / solid_angle(disk).value() - 1);
}

/// The same of a square's with sides of 2a, seen from above its centre.
[[nodiscard]] inline double small_square_error(double a) {
    return std::abs(4 * square(a) / centred_rectangle_solid_angle(a, a, 1.0).value() - 1);
}

/// And of A / r^2 for the irradiance that a disk gives a parallel receiver, R^2 / (R^2 + 1).
[[nodiscard]] inline double small_lamp_error(double radius) {
    const Disk<double> disk{{0, 0, 1}, {0, 0, 1}, radius};
    return std::abs(std::numbers::pi * square(radius) / projected_solid_angle(disk).value() - 1);
}

}  // namespace sr
