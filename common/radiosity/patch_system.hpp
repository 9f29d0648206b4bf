#pragma once
/// @file patch_system.hpp

#include <utility>

#include "radiosity/form_factor_matrix.hpp"
#include "radiosity/patches.hpp"
#include "radiosity/radiosity_system.hpp"

namespace sr {

/// The equations of patches whose form factors are known.
/// @pre as many rows as patches
[[nodiscard]] inline RadiositySystem system_of(const Patches& patches, FormFactorMatrix form_factors) {
    RadiositySystem system{std::move(form_factors), {}, patches.reflectance, patches.emission};
    for (const auto& shape : patches.shapes) system.area.push_back(shape.area());
    return system;
}

}  // namespace sr
