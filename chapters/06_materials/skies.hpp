#pragma once
/// @file skies.hpp
/// Three skies: the radiance that arrives from the direction w above the horizon, in units of the sky's own.

#include <cmath>
#include <numbers>

#include "math/angle.hpp"
#include "math/vector.hpp"

namespace sr {

struct UniformSky {
    [[nodiscard]] double operator()(const Vector3<double>&) const { return 1; }
};

/// Light from one half, the one of +x.
struct StepSky {
    [[nodiscard]] double operator()(const Vector3<double>& w) const { return w.x > 0 ? 1 : 0; }
};

/// The CIE's clear sky, equation (6.5), in units of the radiance of its zenith; without the sun itself.
/// @see CIE S 011 / ISO 15469, Spatial Distribution of Daylight (2004), type 12; Kittler (1967)
struct ClearSky {
    Vector3<double> sun;  ///< unit vector to it, above the horizon

    [[nodiscard]] double operator()(const Vector3<double>& w) const {
        return about_sun(angle_between(w, sun)) * from_zenith(w.z) /
               (about_sun(angle_between({0, 0, 1}, sun)) * from_zenith(1));
    }

private:
    static double about_sun(double angle) {
        const double c = std::cos(angle);
        return 1 + 10 * (std::exp(-3 * angle) - std::exp(-1.5 * std::numbers::pi)) + 0.45 * c * c;
    }
    static double from_zenith(double cosine) { return 1 - std::exp(-0.32 / cosine); }
};

}  // namespace sr
