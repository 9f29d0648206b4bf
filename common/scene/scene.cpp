/// @file scene.cpp

#include "scene/scene.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <stdexcept>
#include <utility>
#include <variant>

#include "math/finite_in_float.hpp"

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

void check_index(const char* of, std::size_t i, const char* what, std::size_t index, std::size_t count) {
    if (!(index < count))
        throw std::invalid_argument(
            fmt::format("{} {} has {} {}, of which there are {}; must be less", of, i, what, index, count));
}

void check_place(const char* of, std::size_t i, const char* what, const Vector3<double>& p) {
    if (!finite_in_float(p))
        throw std::invalid_argument(fmt::format(
            "{} {} has {} at ({}, {}, {}); each must be finite, also in float", of, i, what, p.x, p.y, p.z));
}

void check_face(const Scene& scene, std::size_t i) {
    check_index("face", i, "material", scene.material_of_face[i], scene.materials.size());
    for (const auto vertex : scene.mesh.faces[i]) {
        check_index("face", i, "vertex", vertex, scene.mesh.vertices.size());
        check_place("face", i, "a corner", scene.mesh.vertices[vertex]);
    }
}

void check_ball(const Scene& scene, std::size_t i) {
    check_index("ball", i, "material", scene.balls[i].material, scene.materials.size());
    const auto& [centre, radius] = scene.balls[i].sphere;
    check_place("ball", i, "its centre", centre);
    using Float = std::numeric_limits<float>;
    if (!(radius >= Float::min() && radius <= Float::max()))  // a smaller float has fewer digits
        throw std::invalid_argument(
            fmt::format("ball {} has a radius of {}; must be from {} to {}, as in float", i, radius,
                        Float::min(), Float::max()));
}

}  // namespace

void check_scene(const Scene& scene) {
    for (const auto& material : scene.materials)
        check_emission(fmt::format("material '{}'", material.name), material.emission);
    check_emission("background", scene.background);
    if (scene.material_of_face.size() != scene.mesh.faces.size())
        throw std::invalid_argument(fmt::format("{} faces, and materials for {} of them; must be as many",
                                                scene.mesh.faces.size(), scene.material_of_face.size()));
    for (std::size_t i = 0; i < scene.mesh.faces.size(); ++i) check_face(scene, i);
    for (std::size_t i = 0; i < scene.balls.size(); ++i) check_ball(scene, i);
}

}  // namespace sr
