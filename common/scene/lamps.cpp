/// @file lamps.cpp

#include "scene/lamps.hpp"

namespace sr {

std::vector<PointLight> lights_of_lamps(const Scene& scene) {
    std::vector<PointLight> lights;
    for (std::size_t material = 0; material < scene.materials.size(); ++material) {
        const Spectrum L = scene.materials[material].emission;
        if (L == Spectrum{}) continue;
        double          area_sum = 0;
        Vector3<double> moment{0, 0, 0};
        for (std::size_t face = 0; face < scene.mesh.faces.size(); ++face) {
            if (scene.material_of_face[face] != material) continue;
            const auto   triangle = scene.mesh.triangle(face);
            const double A        = area(triangle);
            area_sum += A;
            moment += A / 3 * (triangle.a + triangle.b + triangle.c);
        }
        if (area_sum > 0) lights.push_back({moment / area_sum, float(area_sum) * L});
    }
    return lights;
}

}  // namespace sr
