#pragma once
/// @file scene.hpp
/// What there is to see: triangles, and what each is made of.

#include <cstdint>
#include <string>
#include <vector>

#include "geometry/mesh.hpp"
#include "radiometry/spectrum.hpp"

namespace sr {

/// A surface that scatters diffusely and may shine.
struct Material {
    std::string name;
    Spectrum    reflectance;  ///< share of the light that leaves again, 0 to 1 [1]
    Spectrum    emission;     ///< radiance that it emits by itself [W/(m^2 sr)]
};

/// A mesh whose face i is made of materials[material_of_face[i]].
struct Scene {
    Mesh<double>               mesh;
    std::vector<Material>      materials;
    std::vector<std::uint32_t> material_of_face;
};

}  // namespace sr
