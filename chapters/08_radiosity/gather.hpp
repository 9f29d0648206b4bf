#pragma once
/// @file gather.hpp
/// The radiosity at a point from those of all patches.

#include <cstddef>

#include "radiosity/patches.hpp"
#include "radiosity/point_form_factors.hpp"
#include "radiosity/radiosity_system.hpp"
#include "radiosity/visible_share.hpp"
#include "sampling/rng.hpp"

namespace sr {

/// A point of a polygon that is about to be shaded.
struct ShadedPoint {
    SurfacePoint<double> surface;
    DoubleSpectrum       reflectance, emission;
};

/// (8.22): what the point emits and reflects [W/m^2]. Without `visibility`, of patches that nothing hides.
[[nodiscard]] inline DoubleSpectrum gathered(const ShadedPoint& point, const Patches& patches,
                                             const Radiosities& radiosities,
                                             const Visibility* visibility = nullptr, int side = 4) {
    Rng            rng{86, 0, 0, 0};
    DoubleSpectrum irradiance;
    for (std::size_t j = 0; j < patches.size(); ++j) {
        const Patch& patch = patches.shapes[j];  // (8.22) from all patches that may be seen
        double       F     = contour_form_factor(point.surface.position, point.surface.normal, patch);
        if (!(F > 0)) continue;
        if (visibility) F *= visible_share(point.surface, patch, *visibility, side, rng);
        irradiance = irradiance + F * radiosities[j];
    }
    return point.emission + point.reflectance * irradiance;
}

}  // namespace sr
