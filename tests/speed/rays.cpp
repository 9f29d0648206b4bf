/// @file rays.cpp
/// Rays per second on the teapot: primary, diffuse bounce and shadow, one thread.
///
/// `wrong` counts the rays, of those that brute force had the time for, whose answer differs from brute
/// force's in any bit. `leaks` counts lost rays among those aimed at vertices that look at the ray's origin.

#include <cmath>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "course/bench.hpp"
#include "course/progress.hpp"
#include "course/timing.hpp"
#include "geometry/hierarchy.hpp"
#include "math/frame.hpp"
#include "sampling/hemisphere.hpp"
#include "sampling/rng.hpp"
#include "scene/camera.hpp"
#include "scene/teapot.hpp"

namespace sr {
namespace {

constexpr int    image_side        = 768;  // [pixel]: 590 000 primary rays
constexpr int    repeats           = 5;
constexpr double brute_force_tests = 1e8;  // ray-triangle tests for each set of rays and repeat
constexpr int    vertex_aimed_rays = 1'000'000;
constexpr Vec3   light{-3, -5, 9};

/// Rays of one kind, and whether the question is "what first?" or "anything?".
struct RaySet {
    std::string             name;
    std::vector<Ray<float>> rays;
    std::vector<Vec3>       origins_of_aimed;  ///< where vertex-aimed rays of this kind start from
    bool                    any_hit = false;
};

template <class Surfaces>
bool hits(const Surfaces& surfaces, const Ray<float>& ray, Interval<float> range, bool any_hit) {
    if constexpr (requires { surfaces.occluded(ray, range); }) {
        if (any_hit) return surfaces.occluded(ray, range);
    }
    return surfaces.nearest(ray, range).has_value();
}

/// Primary rays, and from where they hit a bounce and a ray to the light.
std::vector<RaySet> ray_sets(const Mesh<float>& mesh, const Hierarchy<float>& hierarchy) {
    const Vector3<double> eye{2.6, -8.2, 4.2}, target{0.2, 0, 1.45};
    const auto            camera = convert<float>(
        pinhole_camera<double>(eye, target - eye, {0, 0, 1}, 1.0, 0.82, image_side, image_side));
    RaySet primary{"primary", {}, {camera.position}}, diffuse{"diffuse", {}, {}},
        shadow{"shadow", {}, {light}, true};
    for (int y = 0; y < image_side; ++y) {
        for (int x = 0; x < image_side; ++x) {
            const auto ray = camera.ray_through_pixel(x, y);
            primary.rays.push_back(ray);
            const auto hit = hierarchy.nearest(ray);
            if (!hit) continue;
            Vec3 n = normalize(area_vector(mesh.triangle(hit->face)));
            if (dot(n, ray.direction) > 0) n = -n;
            const Vec3  p = ray.at(hit->t) + 1e-3F * n;
            Rng         rng{1, x, y, 0};
            const float u = rng.uniform(), v = rng.uniform();
            diffuse.rays.push_back({p, frame_around(n).to_world(sample_cosine_hemisphere({u, v}))});
            diffuse.origins_of_aimed.push_back(p);
            shadow.rays.push_back({p, light - p});
        }
    }
    return {std::move(primary), std::move(diffuse), std::move(shadow)};
}

/// The faces around each vertex, and which vertices they enclose without a gap.
class Fans {
public:
    explicit Fans(const Mesh<float>& mesh)
        : mesh_(mesh), faces_(mesh.vertices.size()), open_(mesh.vertices.size(), false) {
        std::map<std::pair<std::uint32_t, std::uint32_t>, int> sides;
        for (std::uint32_t face = 0; face < mesh.faces.size(); ++face) {
            for (std::size_t i = 0; i < 3; ++i) {
                const auto a = mesh.faces[face][i], b = mesh.faces[face][(i + 1) % 3];
                faces_[a].push_back(face);
                ++sides[std::minmax(a, b)];
            }
        }
        for (const auto& [ends, count] : sides) {
            if (count != 2) open_[ends.first] = open_[ends.second] = true;
        }
    }

    /// Whether the faces around the vertex all show their front to the point, and not from the edge: then a
    /// ray from there to the vertex can't pass, whatever its rounding.
    [[nodiscard]] bool faces_point(std::uint32_t vertex, Vec3 point) const {
        const Vec3 towards = point - mesh_.vertices[vertex];
        if (open_[vertex] || faces_[vertex].empty()) return false;
        for (const auto face : faces_[vertex]) {
            const Vec3 n = area_vector(mesh_.triangle(face));
            if (!(dot(n, towards) > 0.02F * length(n) * length(towards))) return false;
        }
        return true;
    }

private:
    const Mesh<float>&                      mesh_;
    std::vector<std::vector<std::uint32_t>> faces_;
    std::vector<bool>                       open_;
};

template <class Surfaces>
int leaks(const Surfaces& surfaces, const Mesh<float>& mesh, const Fans& fans, const RaySet& set, int rays) {
    int lost = 0;
    Rng rng{2, 0, 0, 0};
    for (int aimed = 0; aimed < rays;) {
        const auto vertex = static_cast<std::uint32_t>(rng.uniform<double>() * double(mesh.vertices.size()));
        const auto from =
            static_cast<std::size_t>(rng.uniform<double>() * double(set.origins_of_aimed.size()));
        const Vec3 origin = set.origins_of_aimed[from];
        if (!fans.faces_point(vertex, origin)) continue;
        ++aimed;
        lost += hits(surfaces, {origin, mesh.vertices[vertex] - origin}, {0, 1.0001F}, set.any_hit) ? 0 : 1;
    }
    return lost;
}

/// Rays that brute force has the time for, spread over the set.
std::vector<Ray<float>> subset(const RaySet& set, std::size_t triangles) {
    const auto              count = static_cast<std::size_t>(brute_force_tests / double(triangles));
    std::vector<Ray<float>> result;
    for (std::size_t i = 0; i < count; ++i) result.push_back(set.rays[i * set.rays.size() / count]);
    return result;
}

void bench(int level, course::Rows& rows, course::Progress& progress) {
    const auto              mesh = convert<float>(teapot(level));
    const Hierarchy<float>  hierarchy(mesh);
    const BruteForce<float> all(mesh);
    const Fans              fans(mesh);
    for (const RaySet& set : ray_sets(mesh, hierarchy)) {
        const auto    some    = subset(set, mesh.faces.size());
        std::uint64_t hit     = 0;  // keeps the work from being optimised away
        const auto    timings = course::measure({{"brute force",
                                                  [&] {
                                                   for (const auto& ray : some)
                                                       hit += hits(all, ray, in_front<float>, set.any_hit);
                                               }},
                                                 {"binary hierarchy",
                                                  [&] {
                                                   for (const auto& ray : set.rays)
                                                       hit +=
                                                           hits(hierarchy, ray, in_front<float>, set.any_hit);
                                               }}},
                                                repeats);
        int           wrong   = 0;
        for (const auto& ray : some) wrong += all.nearest(ray) == hierarchy.nearest(ray) ? 0 : 1;
        const int lost[] = {leaks(all, mesh, fans, set, static_cast<int>(some.size())),
                            leaks(hierarchy, mesh, fans, set, vertex_aimed_rays)};
        for (std::size_t i = 0; i < 2; ++i) {
            const double millions = double(i == 0 ? some.size() : set.rays.size()) / 1e6;
            rows.add({"teapot", mesh.faces.size(), set.name, timings[i].name, millions / timings[i].median,
                      millions / timings[i].max, millions / timings[i].min, i == 0 ? 0 : wrong,
                      hit > 0 ? lost[i] : -1});
        }
        progress.tick();
    }
}

}  // namespace
}  // namespace sr

int main(int argc, char** argv) {
    return sr::course::run_benchmark(
        argc, argv, "Rays per second on the teapot: primary, diffuse bounce and shadow, one thread.", [] {
            sr::course::Rows rows{
                {"mesh", "triangles", "rays", "method", "mrays_per_s", "min", "max", "wrong", "leaks"}};
            sr::course::Progress progress("tracing", 6);
            for (const int level : {40, 125}) sr::bench(level, rows, progress);
            return rows;
        });
}
