/// @file scene.cpp

#include "scene/scene.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>
#include <variant>

namespace sr {

Spectrum Material::reflectance() const {
    Spectrum sum;
    for (const auto& part : scattering.lobes()) sum = sum + part.weight;
    return sum;
}

bool Material::is_transparent() const {
    return std::ranges::any_of(scattering.lobes(), [](const auto& part) {
        return std::holds_alternative<Dielectric<float>>(part.lobe);
    });
}

Material diffuse_material(std::string name, Spectrum reflectance, Spectrum emission) {
    if (!each_in(reflectance, 0, 1))
        throw std::invalid_argument(
            fmt::format("reflectance of material '{}' is ({}, {}, {}); each must be from 0 to 1", name,
                        reflectance.r, reflectance.g, reflectance.b));
    return {std::move(name), LobeSum<float>{{{reflectance, Diffuse<float>{}}}}, emission};
}

namespace {

void check_emission(const std::string& what, Spectrum L) {
    if (!each_in(L, 0, std::numeric_limits<float>::max()))
        throw std::invalid_argument(
            fmt::format("{} emits ({}, {}, {}); each must be finite and not negative", what, L.r, L.g, L.b));
}

void check_material_index(const char* of, std::size_t i, std::uint32_t material, const Scene& scene) {
    if (!(material < scene.materials.size()))
        throw std::invalid_argument(
            fmt::format("{} {} is of material {}, of which there are {}; must be less", of, i, material,
                        scene.materials.size()));
}

}  // namespace

void check_scene(const Scene& scene) {
    for (const auto& material : scene.materials)
        check_emission(fmt::format("material '{}'", material.name), material.emission);
    check_emission("background", scene.background);
    if (scene.material_of_face.size() != scene.mesh.faces.size())
        throw std::invalid_argument(fmt::format("{} faces, and materials for {} of them; must be as many",
                                                scene.mesh.faces.size(), scene.material_of_face.size()));
    for (std::size_t i = 0; i < scene.material_of_face.size(); ++i)
        check_material_index("face", i, scene.material_of_face[i], scene);
    for (std::size_t i = 0; i < scene.balls.size(); ++i) {
        check_material_index("ball", i, scene.balls[i].material, scene);
        const auto& [centre, radius] = scene.balls[i].sphere;
        if (!(radius > 0 && std::isfinite(radius)))
            throw std::invalid_argument(
                fmt::format("ball {} has a radius of {}; must be positive and finite", i, radius));
        if (!(std::isfinite(centre.x) && std::isfinite(centre.y) && std::isfinite(centre.z)))
            throw std::invalid_argument(
                fmt::format("ball {} has its centre at ({}, {}, {}); each must be finite", i, centre.x,
                            centre.y, centre.z));
    }
}

}  // namespace sr
