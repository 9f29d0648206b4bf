/// @file rays.cpp
/// Rays per second on the teapot: primary, diffuse bounce and shadow, one thread; for each rung of the ladder from
/// brute force to the swept hierarchy, with what it takes to build and the memory that it takes.
///
/// - `mesh`, `triangles`: the teapot, coarse and fine.
/// - `rays`: which question is asked; `method`: how it is answered.
/// - `mrays_per_s`: millions of rays in a second, in the fastest of five repeats; `slowest`: in the slowest one.
/// - `wrong`: of the rays that brute force had the time for, those whose answer to the question that is timed differs
///   from brute force's: in any bit of the nearest hit, or in whether there is one.
/// - `leaks`: lost rays among those aimed at vertices that look at the ray's origin.
/// - `build_s`: seconds to build the hierarchy.
/// - `bytes_per_triangle`: of memory.
///
/// Expect `wrong` and `leaks` to be 0, and trees cut by cost to be ahead of the median's; swept and binned ones can
/// hardly be told apart.
///
/// It takes a minute or two.

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "course/bench.hpp"
#include "course/progress.hpp"
#include "course/timing.hpp"
#include "geometry/hierarchy.hpp"
#include "geometry/neighbours.hpp"
#include "geometry/offset.hpp"
#include "math/frame.hpp"
#include "sampling/hemisphere.hpp"
#include "sampling/rng.hpp"
#include "scene/camera.hpp"
#include "scene/teapot.hpp"

namespace sr {
namespace {

constexpr int    image_side        = 768;  // [pixel]: 590 000 primary rays
constexpr int    repeats           = 5;
constexpr int    build_repeats     = 3;
constexpr double brute_force_tests = 4e7;  // ray-triangle tests for each set of rays and repeat
constexpr int    vertex_aimed_rays = 1'000'000;
constexpr Vec3   light{-3, -5, 9};

/// Rays of one kind, and whether the question is "what first?" or "anything?".
struct RaySet {
    std::string             name;
    std::vector<Ray<float>> rays;
    std::vector<Vec3>       origins_of_aimed;  ///< where vertex-aimed rays of this kind start from
    Interval<float>         range   = in_front<float>;
    bool                    any_hit = false;
};

template <class Surfaces>
bool hits(const Surfaces& surfaces, const Ray<float>& ray, Interval<float> range, bool any_hit) {
    if constexpr (requires { surfaces.occluded(ray, range); }) {
        if (any_hit) return surfaces.occluded(ray, range);
    }
    return surfaces.nearest(ray, range).has_value();
}

/// Primary rays, and from where they hit a bounce and a ray to the light. The latter starts on the light's side of the
/// surface: inside the pot, where that turns its back to the light.
std::vector<RaySet> ray_sets(const Mesh<float>& mesh, const Hierarchy<float>& hierarchy) {
    const Vector3<double> eye{2.6, -8.2, 4.2}, target{0.2, 0, 1.45};
    const auto            camera = convert<float>(
        pinhole_camera<double>(eye, target - eye, {0, 0, 1}, 1.0, 0.82, image_side, image_side));
    RaySet primary{"primary", {}, {camera.position}}, diffuse{"diffuse", {}, {}},
        shadow{"shadow", {}, {light}, before_the_end<float>, true};
    for (int y = 0; y < image_side; ++y) {
        for (int x = 0; x < image_side; ++x) {
            const auto ray = camera.ray_through_pixel(x, y);
            primary.rays.push_back(ray);
            const auto hit = hierarchy.nearest(ray);
            if (!hit) continue;
            const auto  p = surface_point(mesh.triangle(hit->face), hit->uv);
            const Vec3  n = dot(p.normal, ray.direction) < 0 ? p.normal : -p.normal;
            Rng         rng{1, x, y, 0};
            const float u = rng.uniform(), v = rng.uniform();
            diffuse.rays.push_back(leave(p, frame_around(n).to_world(sample_cosine_hemisphere(Vec2{u, v}))));
            diffuse.origins_of_aimed.push_back(diffuse.rays.back().origin);
            shadow.rays.push_back(between(p, light));
        }
    }
    return {std::move(primary), std::move(diffuse), std::move(shadow)};
}

constexpr std::array<std::pair<const char*, Cut>, 3> rungs{
    {{"median", Cut::median}, {"binned", Cut::binned}, {"swept", Cut::swept}}};

/// The memory that a hierarchy takes [byte].
double bytes(const Hierarchy<float>& hierarchy) {
    const auto& tree = hierarchy.tree();
    return double(tree.nodes.size() * sizeof(tree.nodes[0]) +
                  tree.triangles.size() * sizeof(tree.triangles[0]));
}

/// A teapot, and all that is asked about it.
struct Pot {
    explicit Pot(int level) : mesh(convert<float>(teapot(level))), all(mesh), neighbours(mesh) {
        std::vector<course::Work> builds;
        for (std::size_t i = 0; i < rungs.size(); ++i)
            builds.push_back({rungs[i].first, [this, i] {
                                  hierarchies[i].emplace(mesh, HierarchyOptions{.cut = rungs[i].second});
                              }});
        build = course::measure(builds, build_repeats);
    }

    Mesh<float>                                               mesh;
    BruteForce<float>                                         all;
    Neighbours                                                neighbours;
    std::array<std::optional<Hierarchy<float>>, rungs.size()> hierarchies;
    std::vector<course::Timing>                               build;  ///< of each hierarchy
};

/// How many of a set's rays each method gets wrong, or lets through a vertex.
using Counts = std::array<int, rungs.size()>;

Counts answers_that_differ(const Pot& pot, const RaySet& set, const std::vector<Ray<float>>& rays) {
    Counts different{};
    for (const auto& ray : rays) {
        const auto expected = pot.all.nearest(ray, set.range);
        for (std::size_t i = 0; i < rungs.size(); ++i) {
            const Hierarchy<float>& hierarchy = *pot.hierarchies[i];
            const bool same = set.any_hit ? hierarchy.occluded(ray, set.range) == expected.has_value()
                                          : hierarchy.nearest(ray, set.range) == expected;
            different[i] += same ? 0 : 1;
        }
    }
    return different;
}

/// Rays from where the set's own start to vertices that they can't pass.
std::vector<Ray<float>> vertex_aimed(const Pot& pot, const RaySet& set, int count) {
    const auto&             vertices = pot.mesh.vertices;
    std::vector<Ray<float>> rays;
    Rng                     rng{2, 0, 0, 0};
    while (int(rays.size()) < count) {
        const auto vertex = std::uint32_t(rng.uniform<double>() * double(vertices.size()));
        const auto from   = std::size_t(rng.uniform<double>() * double(set.origins_of_aimed.size()));
        const Vec3 origin = set.origins_of_aimed[from];
        if (walls_off(pot.mesh, pot.neighbours, vertex, origin))
            rays.push_back({origin, vertices[vertex] - origin});
    }
    return rays;
}

template <class Surfaces>
int leaks(const Surfaces& surfaces, const RaySet& set, std::span<const Ray<float>> aimed) {
    return int(std::count_if(aimed.begin(), aimed.end(), [&](const Ray<float>& ray) {
        return !hits(surfaces, ray, {0, 1.0001F}, set.any_hit);
    }));
}

/// Rays that brute force has the time for, spread over the set.
std::vector<Ray<float>> subset(const RaySet& set, std::size_t triangles) {
    const auto              count = std::size_t(brute_force_tests / double(triangles));
    std::vector<Ray<float>> result;
    for (std::size_t i = 0; i < count; ++i) result.push_back(set.rays[i * set.rays.size() / count]);
    return result;
}

/// What a set of rays tells the progress: each repeat of each method, then each of two checks.
constexpr int steps = repeats * (1 + int(rungs.size())) + 2;

void bench(const Pot& pot, const RaySet& set, course::Rows& rows, course::Progress& progress) {
    const auto    some  = subset(set, pot.mesh.faces.size());
    std::uint64_t hit   = 0;  // looked at below: work whose result nobody needs is optimised away
    const auto    trace = [&](const auto& surfaces, const std::vector<Ray<float>>& rays) {
        for (const auto& ray : rays) hit += hits(surfaces, ray, set.range, set.any_hit);
        progress.tick();
    };
    std::vector<course::Work> work{{"brute force", [&] { trace(pot.all, some); }}};
    for (std::size_t i = 0; i < rungs.size(); ++i)
        work.push_back({rungs[i].first, [&, i] { trace(*pot.hierarchies[i], set.rays); }});
    const auto timings = course::measure(work, repeats);

    const Counts wrong = answers_that_differ(pot, set, some);
    progress.tick();
    const auto                        aimed = vertex_aimed(pot, set, vertex_aimed_rays);
    const std::span<const Ray<float>> few(aimed.data(), std::min(some.size(), aimed.size()));
    const auto add = [&](const course::Timing& timing, std::size_t rays, int different, int lost,
                         double build, double bytes_each) {
        const double millions = double(rays) / 1e6;
        rows.add({"teapot", pot.mesh.faces.size(), set.name, timing.name, millions / timing.seconds,
                  millions / timing.slowest, different, lost, build, bytes_each});
    };
    add(timings[0], some.size(), 0, leaks(pot.all, set, few), 0, double(sizeof(FaceTriangle<float>)));
    for (std::size_t i = 0; i < rungs.size(); ++i) {
        const auto& hierarchy = *pot.hierarchies[i];
        add(timings[i + 1], set.rays.size(), wrong[i], leaks(hierarchy, set, aimed), pot.build[i].seconds,
            bytes(hierarchy) / double(pot.mesh.faces.size()));
    }
    progress.tick();
    if (hit == 0) throw std::logic_error("no ray of the benchmark hit the teapot");
}

}  // namespace
}  // namespace sr

int main(int argc, char** argv) {
    return sr::course::run_benchmark(
        argc, argv,
        "Rays per second on the teapot: primary, diffuse bounce and shadow, one thread, for every way to "
        "build.",
        [] {
            sr::course::Rows rows{{"mesh", "triangles", "rays", "method", "mrays_per_s", "slowest", "wrong",
                                   "leaks", "build_s", "bytes_per_triangle"}};
            sr::course::Progress progress("tracing", 2 * 3 * sr::steps);
            for (const int level : {40, 125}) {
                const sr::Pot pot(level);
                for (const auto& set : sr::ray_sets(pot.mesh, *pot.hierarchies.back()))
                    sr::bench(pot, set, rows, progress);
            }
            return rows;
        });
}
