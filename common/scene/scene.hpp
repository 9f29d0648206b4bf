#pragma once
/// @file scene.hpp
/// What there is to see: triangles and spheres, what each is made of, and what lights them. Quantities with units end
/// here: a renderer adds and weighs radiances and nothing else, and types that are all alike tell nothing apart. What
/// is emitted is a bare Spectrum, and its unit stands beside it.

#include <cstdint>
#include <string>
#include <vector>

#include "geometry/mesh.hpp"
#include "geometry/sphere.hpp"
#include "material/lobe_sum.hpp"
#include "radiometry/spectrum.hpp"
#include "scene/light.hpp"

namespace sr {

/// How a surface scatters light, and what it emits by itself.
struct Material {
    std::string    name;
    LobeSum<float> scattering    = {};
    Spectrum       emission      = {};    ///< radiance [W/(m^2 sr)]
    bool           shines_behind = true;  ///< also from the side of faces where their normals don't point

    /// The share of the light that the lobes scatter: the sum of their weights [1].
    [[nodiscard]] Spectrum reflectance() const;

    /// Whether light goes through it. Such a surface has an inside, where its normals don't point; all others look
    /// the same from either side.
    [[nodiscard]] bool is_transparent() const;
};

/// @param reflectance  share of the light that leaves again, 0 to 1 [1]
/// @throws std::invalid_argument that names the material, if the reflectance is not from 0 to 1
[[nodiscard]] Material diffuse_material(std::string name, Spectrum reflectance, Spectrum emission = {});

/// A sphere made of materials[material].
struct Ball {
    Sphere<double> sphere;
    std::uint32_t  material = 0;
};

/// A mesh whose face i is made of materials[material_of_face[i]], and spheres, which lenses need to be: a mesh
/// refracts as many ways as it has faces.
struct Scene {
    Mesh<double>               mesh             = {};
    std::vector<Material>      materials        = {};
    std::vector<std::uint32_t> material_of_face = {};
    std::vector<Ball>          balls            = {};
    std::vector<PointLight>    lights           = {};  ///< intensities [W/sr]
    Spectrum                   background       = {};  ///< radiance from where nothing is [W/(m^2 sr)]
};

/// What is traced in float must be possible there; the lights see to that themselves.
/// @throws std::invalid_argument that names what can't be: a material or a background that emits less than nothing,
///         a material or a vertex that is missing, a corner or a ball too far away, a ball too small or too large
void check_scene(const Scene& scene);

}  // namespace sr
