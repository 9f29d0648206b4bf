/// @file intersect.cpp
/// Nanoseconds for one test of one ray against one thing: every intersector, in float and double, one thread.
///
/// Rays start on all sides at a distance of 4 and are aimed into a ball of radius 1.5; things lie in one of radius
/// 1, implicit surfaces in one of about 3. So some hit and some miss, as `hit_percent` says, and no branch is
/// predicted for free. Every ray asks every thing: what is prepared for a ray or for a triangle beforehand is not
/// timed for each test.
///
/// - `thing`, `method`: what is hit, and how that is computed.
/// - `effort`: of searches: steps, or the tolerance.
/// - `precision`: float or double.
/// - `ns`: nanoseconds for a test, in the fastest repeat; `slowest`: in the slowest one.
/// - `hit_percent`: of the tests. A search with a tolerance also hits what passes by so near.
///
/// Expect a few nanoseconds for what has a formula, and many times as many for what is searched for.
///
/// It takes a minute or two.

#include <fmt/format.h>

#include <functional>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "course/bench.hpp"
#include "course/progress.hpp"
#include "course/timing.hpp"
#include "geometry/box.hpp"
#include "geometry/implicit_closed_form.hpp"
#include "geometry/implicit_ellipsoid.hpp"
#include "geometry/implicit_hyperboloid.hpp"
#include "geometry/implicit_intervals.hpp"
#include "geometry/implicit_marching.hpp"
#include "geometry/implicit_metaballs.hpp"
#include "geometry/implicit_segment_tracing.hpp"
#include "geometry/implicit_sphere_tracing.hpp"
#include "geometry/implicit_tanglecube.hpp"
#include "geometry/implicit_torus.hpp"
#include "geometry/moeller_trumbore.hpp"
#include "geometry/plane.hpp"
#include "geometry/plane_triangle.hpp"
#include "geometry/sphere.hpp"
#include "geometry/triangle.hpp"
#include "sampling/ball.hpp"
#include "sampling/rng.hpp"

namespace sr {
namespace {

constexpr int repeats = 7;
constexpr int many    = 512;  // rays, and things of a kind: 260 000 tests, some milliseconds
constexpr int few     = 2;    // things of a kind that takes long

/// One way to intersect: what all its tests hit.
struct Contender {
    std::string           thing, method, effort, precision;
    std::function<long()> hits;
    double                tests;
};

template <class T>
Vector3<T> in_ball(T radius, Rng& rng) {
    return radius * in_unit_ball<T>(rng);
}

template <class T>
std::vector<Ray<T>> rays_from_all_sides(T distance, T aim) {
    Rng                 rng{1, 0, 0, 0};
    std::vector<Ray<T>> rays;
    for (int i = 0; i < many; ++i) {
        const Vector3<T> from = distance * normalize(in_ball<T>(1, rng));
        rays.push_back({from, in_ball<T>(aim, rng) - from});
    }
    return rays;
}

/// So many things, each made from the next random numbers.
template <class Make>
auto several(int count, const Make& make) {
    Rng                              rng{2, 0, 0, 0};
    std::vector<decltype(make(rng))> things;
    for (int i = 0; i < count; ++i) things.push_back(make(rng));
    return things;
}

/// Every ray against every thing.
/// @param effort   how finely a search searches: its step or tolerance; "-" for what is no search
/// @param prepare  makes of a ray what asks, once for all things
/// @param test     whether what asks hits a thing
template <class T, class Thing, class Prepare, class Test>
Contender contender(std::string what, std::string method, std::string effort, std::vector<Ray<T>> rays,
                    std::vector<Thing> things, Prepare prepare, Test test) {
    const double tests = double(rays.size()) * double(things.size());
    const auto   hits  = [rays = std::move(rays), things = std::move(things), prepare, test] {
        long count = 0;
        for (const auto& ray : rays) {
            const auto asking = prepare(ray);
            for (const auto& thing : things) count += test(asking, thing) ? 1 : 0;
        }
        return count;
    };
    return {std::move(what),
            std::move(method),
            std::move(effort),
            sizeof(T) == sizeof(float) ? "float" : "double",
            hits,
            tests};
}

template <class T>
void add_shapes(std::vector<Contender>& all) {
    const auto rays = rays_from_all_sides<T>(4, T(1.5));
    const auto same = [](const Ray<T>& ray) { return ray; };

    all.push_back(contender(
        "plane", "(2.2)", "-", rays,
        several(many,
                [](Rng& rng) {
                    const auto point = in_ball<T>(1, rng);
                    return Plane<T>{.point = point, .normal = in_ball<T>(1, rng)};
                }),
        same, [](const Ray<T>& ray, const Plane<T>& plane) { return intersect(plane, ray).has_value(); }));
    all.push_back(contender(
        "sphere", "(2.5)", "-", rays,
        several(many,
                [](Rng& rng) { return Sphere<T>{.centre = in_ball<T>(T(0.5), rng), .radius = T(0.5)}; }),
        same, [](const Ray<T>& ray, const Sphere<T>& sphere) { return intersect(sphere, ray).has_value(); }));
    all.push_back(contender(
        "box", "slabs", "-", rays,
        several(many,
                [](Rng& rng) {
                    Box<T> box;
                    box.include(in_ball<T>(1, rng));
                    box.include(in_ball<T>(1, rng));
                    return box;
                }),
        [](const Ray<T>& ray) { return BoxRay<T>(ray); },
        [](const BoxRay<T>& ray, const Box<T>& box) { return !ray.clip(box, in_front<T>).empty(); }));
}

template <class T>
void add_triangles(std::vector<Contender>& all) {
    const auto rays      = rays_from_all_sides<T>(4, T(1));
    const auto triangles = several(many, [](Rng& rng) {
        const auto a = in_ball<T>(1, rng), b = in_ball<T>(1, rng);
        return Triangle<T>{a, b, in_ball<T>(1, rng)};
    });
    const auto same      = [](const Ray<T>& ray) { return ray; };

    all.push_back(contender("triangle", "Moeller-Trumbore", "-", rays, triangles, same,
                            [](const Ray<T>& ray, const Triangle<T>& triangle) {
                                return intersect_moeller_trumbore(triangle, ray, in_front<T>).has_value();
                            }));
    all.push_back(contender("triangle", "plane and edges", "-", rays,
                            std::vector<PlaneTriangle<T>>(triangles.begin(), triangles.end()), same,
                            [](const Ray<T>& ray, const PlaneTriangle<T>& triangle) {
                                return triangle.intersect(ray, in_front<T>).has_value();
                            }));
    all.push_back(contender(
        "triangle", "watertight", "-", rays, triangles, [](const Ray<T>& ray) { return TriangleRay<T>(ray); },
        [](const TriangleRay<T>& ray, const Triangle<T>& triangle) {
            return ray.intersect(triangle, in_front<T>).has_value();
        }));
}

/// All searches along a ray.
template <class T, class Surface>
void add_searches(std::vector<Contender>& all, const std::string& name, const Surface& surface) {
    const auto rays = rays_from_all_sides<T>(8, T(3));
    const auto add  = [&](const std::string& method, const std::string& effort, const auto& search) {
        all.push_back(contender(
             name, method, effort, rays, std::vector<Surface>(few, surface),
             [](const Ray<T>& ray) {
                return Ray<T>{ray.origin, normalize(ray.direction)};
            },
             [search](const Ray<T>& ray, const Surface& one) { return search(one, ray).has_value(); }));
    };
    const Interval<T> range = in_front<T>;
    const double      step = 0.02, tolerance = 1e-4;
    const std::string steps = fmt::format("step {}", step), within = fmt::format("tolerance {}", tolerance);
    const T           width     = T(tolerance);
    const T           lipschitz = lipschitz_bound<T>(surface, surface.bounds());
    if constexpr (AlgebraicSurface<Surface, T>)
        add("closed form", "-",
            [=](const Surface& one, const Ray<T>& ray) { return solve(one, ray, range); });
    add("marching", steps,
        [=](const Surface& one, const Ray<T>& ray) { return march(one, ray, range, T(step)); });
    add("sphere tracing", within, [=](const Surface& one, const Ray<T>& ray) {
        return sphere_trace(one, ray, range, lipschitz, width);
    });
    add("segment tracing", within,
        [=](const Surface& one, const Ray<T>& ray) { return segment_trace(one, ray, range, width); });
    add("intervals", within,
        [=](const Surface& one, const Ray<T>& ray) { return bisect_intervals(one, ray, range, width); });
}

template <class T>
void add_all(std::vector<Contender>& all) {
    add_shapes<T>(all);
    add_triangles<T>(all);
    add_searches<T>(all, "ellipsoid", Ellipsoid<T>{{2, 1, 3}});
    add_searches<T>(all, "hyperboloid", Hyperboloid<T>{{T(0.6), T(0.6), T(0.8)}, 2});
    add_searches<T>(all, "torus", Torus<T>{2, T(0.5)});
    add_searches<T>(all, "tanglecube", Tanglecube<T>{});
    add_searches<T>(all, "metaballs", Metaballs<T>{{{{-1, 0, 0}, 1}, {{1, 0, 0}, 1}, {{0, 1, 1}, T(0.5)}}});
}

/// All contenders in turn, again and again.
course::Rows measure(const std::vector<Contender>& all) {
    long                      total = 0;  // looked at below: work whose result nobody needs is optimised away
    course::Progress          progress("intersecting", int(all.size()) * repeats);
    std::vector<course::Work> works;
    for (const auto& one : all) {
        works.push_back({one.thing, [&] {
                             total += one.hits();
                             progress.tick();
                         }});
    }
    const auto   timings = course::measure(works, repeats);
    course::Rows rows{{"thing", "method", "effort", "precision", "ns", "slowest", "hit_percent"}};
    for (std::size_t i = 0; i < all.size(); ++i) {
        const auto&  one = all[i];
        const double ns  = 1e9 / one.tests;
        rows.add({one.thing, one.method, one.effort, one.precision, ns * timings[i].seconds,
                  ns * timings[i].slowest, 100 * double(one.hits()) / one.tests});
    }
    if (total == 0) throw std::logic_error("no ray of the benchmark hit anything");
    return rows;
}

}  // namespace
}  // namespace sr

int main(int argc, char** argv) {
    return sr::course::run_benchmark(argc, argv,
                                     "Nanoseconds for one test of a ray: every intersector of the core, "
                                     "float and double, one thread. A search with a tolerance "
                                     "also hits what passes by so near.",
                                     [] {
                                         std::vector<sr::Contender> all;
                                         sr::add_all<float>(all);
                                         sr::add_all<double>(all);
                                         return sr::measure(all);
                                     });
}
