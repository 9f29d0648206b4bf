#pragma once
/// @file lit_part.hpp

#include "radiosity/patches.hpp"
#include "radiosity/radiosity_system.hpp"
#include "radiosity/residual.hpp"

namespace sr {

/// The patches that shine or get light, with the vertices of all: where the others are left out, one looks through a
/// room's outside into it.
[[nodiscard]] inline Patches lit_part(const Patches& patches, const RadiositySystem& system,
                                      const Radiosities& radiosities) {
    Patches lit;
    lit.vertices = patches.vertices;
    for (std::size_t i = 0; i < patches.size(); ++i) {
        const auto arrives = irradiance(system.form_factors, radiosities, i);
        if (!(largest(patches.emission[i]) > 0 || largest(arrives) > 0)) continue;
        lit.corners.push_back(patches.corners[i]);
        lit.shapes.push_back(patches.shapes[i]);
        lit.reflectance.push_back(patches.reflectance[i]);
        lit.emission.push_back(patches.emission[i]);
        lit.polygon.push_back(patches.polygon[i]);
    }
    return lit;
}

}  // namespace sr
