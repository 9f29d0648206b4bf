#pragma once
/// @file phong_albedo.hpp

#include <algorithm>
#include <cmath>
#include <numbers>

#include "math/gauss_legendre.hpp"

namespace sr {

/// Albedo of the lobe cos^e about the mirror direction, the horizon cutting it: the integral over the hemisphere of
/// max(0, r.wi)^e cos(theta_i). It is 2 pi / (e + 2) at theta = 0 and B((e + 1) / 2, 3 / 2) at pi / 2. In cones of
/// angle a about r, those with a < pi / 2 - theta lie above the horizon; of the wider ones an arc of 2 phi does,
/// phi = acos(-cot(theta) cot(a)).
/// @param e      exponent, >= 0
/// @param theta  angle of incidence, 0 to pi / 2 [rad]
/// @return to about 10 digits for whole e up to 1000
[[nodiscard]] inline double phong_albedo(double e, double theta) {
    constexpr double pi = std::numbers::pi;
    const double     c = std::cos(theta), s = std::sin(theta);
    double           sum = 2 * pi * c * (1 - std::pow(s, e + 2)) / (e + 2);
    // pi / 2 - a as a cosine of x: points crowd at both ends, where the integrand has roots
    for (const auto& [x, weight] : gauss_legendre(96, 0, pi)) {
        const double v   = theta * (1 + std::cos(x)) / 2;
        const double phi = std::acos(-std::clamp(s > 0 ? c / s * std::tan(v) : 0.0, 0.0, 1.0));
        const double arc = phi * c * std::sin(v) + s * std::cos(v) * std::sin(phi);
        sum += weight * theta * std::sin(x) * std::pow(std::sin(v), e) * std::cos(v) * arc;
    }
    return sum;
}

}  // namespace sr
