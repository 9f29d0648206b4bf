#pragma once
/// @file reflected.hpp
/// The reflectance equation, as a sum over directions.

#include <cmath>
#include <vector>

#include "material/bsdf.hpp"
#include "math/degrees.hpp"
#include "math/vector.hpp"
#include "sampling/hemisphere_rule.hpp"

namespace sr {

using HemisphereRule = std::vector<WeightedDirection>;

/// Irradiance of a surface under a sky, (6.1) summed over its directions.
template <class Sky>
[[nodiscard]] double irradiance(const Sky& sky, const HemisphereRule& rule) {
    double E = 0;
    for (const auto& [wi, weight] : rule) E += sky(wi) * wi.z * weight;
    return E;
}

/// Radiance that leaves towards wo under a sky. A delta can't be evaluated: its sample is the whole integral.
template <class Lobe, class Sky>
[[nodiscard]] double reflected(const Lobe& lobe, const Sky& sky, const Vector3<double>& wo,
                               const HemisphereRule& rule) {
    if constexpr (DeltaLobe<Lobe, double>) {
        const auto one = lobe.sample(wo, {0.5, 0.5}, TransportMode::radiance);
        return one ? one->weight * sky(one->wi) : 0;
    } else {
        double L = 0;
        // (6.4) BRDF times radiance times cosine times solid angle
        for (const auto& [wi, weight] : rule) L += lobe.f(wo, wi) * sky(wi) * wi.z * weight;
        return L;
    }
}

/// The share of the light from wo that is given back: by reciprocity, what leaves towards wo under a sky of 1.
template <class Lobe>
[[nodiscard]] double albedo(const Lobe& lobe, const Vector3<double>& wo, const HemisphereRule& rule) {
    return reflected(
        lobe, [](const Vector3<double>&) { return 1.0; }, wo, rule);
}

/// The unit vector at an angle [degrees] to the normal, in the plane y = 0, towards +x.
[[nodiscard]] inline Vector3<double> at_angle(double theta) {
    return {std::sin(radians(theta)), 0, std::cos(radians(theta))};
}

}  // namespace sr
