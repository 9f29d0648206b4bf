/// @file lamps.cpp

#include "scene/lamps.hpp"

#include <algorithm>
#include <map>
#include <numeric>
#include <utility>

namespace sr {

namespace {

bool shines(const Scene& scene, std::uint32_t material) {
    return !(scene.materials[material].emission == Spectrum{});
}

/// Vertices in groups. Each names another one of its group, and the last of such a chain itself.
class Groups {
public:
    explicit Groups(std::size_t vertices) : next_(vertices) {
        std::iota(next_.begin(), next_.end(), std::uint32_t{0});
    }

    /// The vertex by which its group is known.
    [[nodiscard]] std::uint32_t of(std::uint32_t vertex) {
        while (next_[vertex] != vertex) vertex = next_[vertex] = next_[next_[vertex]];
        return vertex;
    }
    void join(std::uint32_t a, std::uint32_t b) { next_[of(a)] = of(b); }

private:
    std::vector<std::uint32_t> next_;
};

/// The sums over a lamp's faces.
struct Lamp {
    double          area = 0;
    Vector3<double> area_vector{
        0, 0, 0};  ///< 0 where the faces close, of the length of the area where they are flat
    Vector3<double> moment{0, 0, 0};

    void add(const Triangle<double>& face) {
        const double A = sr::area(face);
        area += A;
        area_vector += sr::area_vector(face) / 2.0;
        moment += A / 3 * (face.a + face.b + face.c);
    }
    [[nodiscard]] double silhouette() const { return std::max(length(area_vector), area / 4); }
};

}  // namespace

std::vector<PointLight> lights_of_lamps(const Scene& scene) {
    Groups groups(scene.mesh.vertices.size());
    for (std::size_t i = 0; i < scene.mesh.faces.size(); ++i) {
        if (!shines(scene, scene.material_of_face[i])) continue;
        const auto [a, b, c] = scene.mesh.faces[i];
        groups.join(a, b);
        groups.join(b, c);
    }
    std::map<std::pair<std::uint32_t, std::uint32_t>, Lamp> lamps;  // by material and group
    for (std::size_t i = 0; i < scene.mesh.faces.size(); ++i) {
        const auto material = scene.material_of_face[i];
        if (shines(scene, material))
            lamps[{material, groups.of(scene.mesh.faces[i][0])}].add(scene.mesh.triangle(i));
    }
    std::vector<PointLight> lights;
    for (const auto& [of, lamp] : lamps) {
        if (lamp.area > 0)
            lights.emplace_back(lamp.moment / lamp.area,
                                float(lamp.silhouette()) * scene.materials[of.first].emission);
    }
    return lights;
}

Scene without_lamps(Scene scene) {
    std::size_t kept = 0;
    for (std::size_t i = 0; i < scene.mesh.faces.size(); ++i) {
        if (shines(scene, scene.material_of_face[i])) continue;
        scene.mesh.faces[kept]       = scene.mesh.faces[i];
        scene.material_of_face[kept] = scene.material_of_face[i];
        ++kept;
    }
    scene.mesh.faces.resize(kept);
    scene.material_of_face.resize(kept);
    std::erase_if(scene.balls, [&](const Ball& ball) { return shines(scene, ball.material); });
    return scene;
}

}  // namespace sr
