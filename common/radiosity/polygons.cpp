/// @file polygons.cpp

#include "radiosity/polygons.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <stdexcept>
#include <variant>

namespace sr {
namespace {

using Point = Vector3<double>;

/// @throws std::invalid_argument if the material does anything but scatter evenly
DoubleSpectrum diffuse_reflectance(const Material& material) {
    DoubleSpectrum sum;
    for (const auto& [weight, lobe] : material.scattering.lobes()) {
        if (weight == Spectrum{}) continue;
        if (!std::holds_alternative<Diffuse<float>>(lobe))
            throw std::invalid_argument(
                fmt::format("material '{}' is not diffuse, and radiosity knows no directions; make it illum "
                            "1, or trace rays",
                            material.name));
        sum = sum + convert<double>(weight);
    }
    return sum;
}

/// @throws std::invalid_argument if something shines or reflects that is no flat face
void check_only_faces(const Scene& scene) {
    if (!scene.balls.empty())
        throw std::invalid_argument("radiosity needs flat faces, and the scene has balls; make each a mesh");
    if (!scene.lights.empty())
        throw std::invalid_argument(
            "radiosity needs faces that shine, and the scene has point lights; make each a small lamp");
    if (scene.background != Spectrum{})
        throw std::invalid_argument(
            "radiosity needs faces that shine, and the scene's background does; put faces around it");
    if (scene.mesh.faces.empty())
        throw std::invalid_argument("radiosity needs faces, and the scene has none");
}

/// The quadrilateral of two faces, if they are one.
std::optional<Patch> quadrilateral(const Mesh<double>& mesh, std::size_t first) {
    const auto &f = mesh.faces[first], &g = mesh.faces[first + 1];
    if (f[0] != g[0] || f[2] != g[1]) return std::nullopt;
    const std::array<Point, 4> p{mesh.vertices[f[0]], mesh.vertices[f[1]], mesh.vertices[f[2]],
                                 mesh.vertices[g[2]]};
    if (!make_a_quadrilateral(p)) return std::nullopt;
    return Patch{p[0], p[1], p[2], p[3]};
}

}  // namespace

std::vector<Polygon> polygons_of(const Scene& scene, ShiningSides sides) {
    check_scene(scene);
    check_only_faces(scene);
    const auto&          mesh = scene.mesh;
    std::vector<Polygon> polygons;
    const auto           add = [&](const Patch& shape, std::uint32_t material) {
        const auto&          of          = scene.materials[material];
        const DoubleSpectrum reflectance = diffuse_reflectance(of);
        const DoubleSpectrum emission    = std::numbers::pi * convert<double>(of.emission);
        polygons.push_back({shape, reflectance, emission, material});
        if (sides == ShiningSides::both)
            polygons.push_back({shape.reversed(), reflectance, emission, material});
    };
    for (std::size_t face = 0; face < mesh.faces.size(); ++face) {
        const std::uint32_t    material = scene.material_of_face[face];
        const Triangle<double> triangle = mesh.triangle(face);
        if (!(area(triangle) > 0)) continue;
        const bool may_pair = face + 1 < mesh.faces.size() && scene.material_of_face[face + 1] == material;
        const auto pair     = may_pair ? quadrilateral(mesh, face) : std::nullopt;
        add(pair ? *pair : Patch{triangle.a, triangle.b, triangle.c}, material);
        if (pair) ++face;
    }
    return polygons;
}

}  // namespace sr
