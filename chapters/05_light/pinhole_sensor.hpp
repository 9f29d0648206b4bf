#pragma once
/// @file pinhole_sensor.hpp
/// Is radiance conserved? Light leaves a unit sphere as a Lambert emitter of radiance 1 sends it, and what arrives
/// behind a pinhole is counted.

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "math/frame.hpp"
#include "math/square.hpp"
#include "radiometry/disk_solid_angle.hpp"
#include "sampled.hpp"
#include "sampling/cone.hpp"

namespace sr {

/// What came through the hole.
struct Arrival {
    double          flux;  ///< [W], as if all that leaves came this way
    Vector2<double> at;    ///< where on the sensor [m]
};

/// A round hole about the origin that looks along +z, and behind it the middle element of a sensor, a square.
struct PinholeSensor {
    double hole = 0.01, depth = 1, side = 0.01;  ///< radius, distance of the sensor, width of the element [m]

    /// Some of the sphere's light: a start on its cap about the axis, a direction in the cone that just holds the hole,
    /// each as likely. Nothing here knows that (5.14) is symmetric.
    /// @param cap  sine of the half-angle of the sphere's cap, as seen from its centre
    [[nodiscard]] std::optional<Arrival> send(double distance, double cap, Rng& rng) const {
        const auto            from = sample_cone(random_point(rng), cap);
        const Vector3<double> normal{from.x, from.y, -from.z};
        const auto            start = Vector3<double>{0, 0, distance} + normal;
        const double          sine  = hole / length(start);
        const auto            in    = sample_cone(random_point(rng), sine);
        const auto            w     = frame_around(normalize(-start)).to_world(in);
        const auto            foot  = Vector2<double>(start - start.z / w.z * w);  // in the hole's plane
        if (dot(normal, w) <= 0 || dot(foot, foot) > square(hole)) return std::nullopt;
        // (5.12) where it leaves: L cos dA d(omega)
        const double flux = dot(normal, w) / (pdf_cone(from, cap).value * pdf_cone(in, sine).value);
        return Arrival{flux, foot - depth / w.z * Vector2<double>(w)};
    }

    /// Flux through the hole over its area [W/m^2].
    [[nodiscard]] Running irradiance(double distance, const Effort& effort) const {
        const double area = std::numbers::pi * square(hole);
        return sampled(effort, [&](Rng& rng) {
            const auto arrival = send(distance, 1, rng);
            return arrival ? arrival->flux / area : 0;
        });
    }

    /// Flux on the element over its area, over the solid angle that the hole fills there, and over the cosine, which in
    /// the middle is 1 [W/(m^2 sr)].
    [[nodiscard]] Running radiance(double distance, const Effort& effort) const {
        const double per_radiance = square(side) * disk_on_axis_solid_angle(hole, depth).value();
        const double corner       = side * std::numbers::sqrt2 / 2;
        const double cap = std::min(1.0, hole + (hole + corner) * distance / depth);  // all that it sees
        return sampled(effort, [&](Rng& rng) {
            const auto arrival = send(distance, cap, rng);
            const bool counts =
                arrival && std::max(std::abs(arrival->at.x), std::abs(arrival->at.y)) <= side / 2;
            return counts ? arrival->flux / per_radiance : 0;
        });
    }
};

}  // namespace sr
