/// @file obj.cpp

#include "scene/obj.hpp"

#include <tiny_obj_loader.h>

#include <stdexcept>

#include "scene/mtl_check.hpp"
#include "scene/obj_check.hpp"

namespace sr {
namespace {

Spectrum to_spectrum(const double (&rgb)[3]) {
    return {float(rgb[0]), float(rgb[1]), float(rgb[2])};
}

LobeSum<float> scattering_of(const tinyobj::material_t& material) {
    const Spectrum Kd = to_spectrum(material.diffuse), Ks = to_spectrum(material.specular);
    switch (mtl_model(material.illum)) {
        case MtlModel::glass:
            return LobeSum<float>{{{{1, 1, 1}, Dielectric<float>{float(material.ior)}}}};
        case MtlModel::phong:
            return LobeSum<float>{{{Kd, Diffuse<float>{}}, {Ks, Phong<float>{float(material.shininess)}}}};
        case MtlModel::mirror:
            return LobeSum<float>{{{Kd, Diffuse<float>{}}, {Ks, Mirror<float>{}}}};
        default:
            return LobeSum<float>{{{Kd, Diffuse<float>{}}}};
    }
}

tinyobj::ObjReader parse(const CheckedObj& text, const std::filesystem::path& path) {
    tinyobj::ObjReaderConfig config;
    config.triangulate  = false;  // the checker did, always along the same diagonals
    config.vertex_color = false;
    tinyobj::ObjReader reader;
    if (!reader.ParseFromString(text.obj, text.mtl, config)) {
        throw std::runtime_error(path.string() + ": " + reader.Error());
    }
    return reader;
}

}  // namespace

Scene read_obj(const std::filesystem::path& path, const Note& note) {
    const CheckedObj         checked = check_obj(path);
    const tinyobj::ObjReader reader  = parse(checked, path);
    for (const auto& line : checked.notes) note(line);

    Scene       scene;
    const auto& xyz = reader.GetAttrib().vertices;
    for (std::size_t i = 0; i < xyz.size(); i += 3)
        scene.mesh.vertices.emplace_back(xyz[i], xyz[i + 1], xyz[i + 2]);
    for (const auto& material : reader.GetMaterials()) {
        scene.materials.push_back({material.name, scattering_of(material), to_spectrum(material.emission)});
    }

    const auto grey     = std::uint32_t(scene.materials.size());
    bool       any_grey = false;
    for (const auto& shape : reader.GetShapes()) {
        const auto& corners = shape.mesh.indices;
        for (std::size_t i = 0; i < corners.size(); i += 3) {
            Mesh<double>::Face face;
            for (std::size_t k = 0; k < 3; ++k) face[k] = std::uint32_t(corners[i + k].vertex_index);
            scene.mesh.faces.push_back(face);
            const int material = shape.mesh.material_ids[i / 3];
            any_grey |= material < 0;
            scene.material_of_face.push_back(material < 0 ? grey : std::uint32_t(material));
        }
    }
    constexpr auto rho = float(default_reflectance);
    if (any_grey) scene.materials.push_back(diffuse_material("grey", {rho, rho, rho}));
    return scene;
}

}  // namespace sr
