#pragma once
/// @file gather.hpp
/// The radiosity at a point from those of all patches.

#include <cstddef>

#include "radiosity/patches.hpp"
#include "radiosity/point_form_factors.hpp"
#include "radiosity/radiosity_system.hpp"
#include "radiosity/visibility.hpp"
#include "sampling/rng.hpp"

namespace sr {

/// A point of a polygon that is about to be shaded.
struct ShadedPoint {
    SurfacePoint<double> surface;
    DoubleSpectrum       reflectance, emission;
};

/// The share of a patch that is seen from a point, by one ray into each of side^2 strata, weighted as (8.5) does.
[[nodiscard]] inline double seen_share(const SurfacePoint<double>& from, const Patch& to,
                                       const Visibility& visibility, int side) {
    Rng    rng{86, 0, 0, 0};
    double all = 0, seen = 0;
    for (int k = 0; k < side * side; ++k) {
        const double u = rng.uniform<double>(), v = rng.uniform<double>();
        const auto   q      = to.sample({(k % side + u) / side, (k / side + v) / side});
        const double weight = form_factor_kernel(from.position, from.normal, q, to.normal());
        all += weight;
        if (weight > 0 && visibility.between(from, to.surface_point(q))) seen += weight;
    }
    return all > 0 ? seen / all : 1;
}

/// (8.22): what the point emits and reflects [W/m^2]. Without `visibility`, of patches that nothing hides.
[[nodiscard]] inline DoubleSpectrum gathered(const ShadedPoint& point, const Patches& patches,
                                             const Radiosities& radiosities,
                                             const Visibility* visibility = nullptr, int side = 4) {
    DoubleSpectrum irradiance;
    for (std::size_t j = 0; j < patches.size(); ++j) {
        const Patch& patch = patches.shapes[j];  // (8.22) from all patches that may be seen
        double       F     = contour_form_factor(point.surface.position, point.surface.normal, patch);
        if (!(F > 0)) continue;
        if (visibility) F *= seen_share(point.surface, patch, *visibility, side);
        irradiance = irradiance + F * radiosities[j];
    }
    return point.emission + point.reflectance * irradiance;
}

}  // namespace sr
