#pragma once
/// @file nested_spheres.hpp
/// A spherical lamp inside spheres of growing size, not in their middle: what passes through each?

#include <cmath>
#include <numbers>

#include "geometry/sphere.hpp"
#include "math/gauss_legendre.hpp"
#include "math/square.hpp"
#include "radiometry/projected_solid_angle.hpp"

namespace sr {

/// The flux of a lamp of radiance 1 and radius 1/2, its centre 1/4 beside that of the sphere: its irradiance, summed up
/// over the sphere's inside. By symmetry one angle is left, whose cosine z is as likely everywhere (Archimedes).
/// @param radius  of the sphere around the lamp, over 3/4
[[nodiscard]] inline double flux_through_sphere(double radius) {
    constexpr double lamp = 0.5, beside = 0.25;
    double           flux = 0;
    for (const auto& [z, weight] : gauss_legendre(64)) {
        // in the frame of a point of the sphere, whose normal points inwards
        const double         r = std::sqrt((1 - z) * (1 + z));
        const Sphere<double> seen{{beside * r, 0, radius - beside * z}, lamp};
        flux += weight * 2 * std::numbers::pi * square(radius) * projected_solid_angle(seen).value();
    }
    return flux;
}

}  // namespace sr
