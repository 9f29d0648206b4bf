#include "geometry/hierarchy.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>

#include "geometry/offset.hpp"
#include "geometry/triangle_packs.hpp"
#include "law.hpp"
#include "mistaken_hierarchy.hpp"
#include "sampling/rng.hpp"
#include "scene/cornell_box.hpp"
#include "scene/teapot.hpp"
#include "transport/tiles.hpp"
#include "vector_of.hpp"

using namespace sr;

namespace {

template <class T>
Vector3<T> random_in(const Box<T>& box, Rng& rng) {
    const T x = T(rng.uniform()), y = T(rng.uniform()), z = T(rng.uniform());
    return box.min + Vector3<T>{x, y, z} * box.size();
}

template <class T>
Box<T> bounds(const Mesh<T>& mesh) {
    Box<T> box;
    for (const auto& vertex : mesh.vertices) box.include(vertex);
    return box;
}

/// Rays of every awkward kind in turn: from anywhere to anywhere, along an axis with zeros of both signs, in
/// the plane of a coordinate that a vertex has, aimed at edges and at vertices, from a point of the mesh.
template <class T>
Ray<T> awkward_ray(const Mesh<T>& mesh, const Box<T>& around, Rng& rng) {
    const auto        face     = std::uint32_t(rng.uniform() * float(mesh.faces.size()));
    const Triangle<T> triangle = mesh.triangle(face);
    const Vector3<T>  o        = random_in(around, rng);
    const T           u        = T(rng.uniform());
    const auto        axis     = int(rng.uniform() * 3);
    const T           zero     = rng.uniform() < 0.5F ? T(0) : -T(0);
    Vector3<T>        along(zero);
    along[axis] = rng.uniform() < 0.5F ? T(1) : T(-1);
    switch (int(rng.uniform() * 6)) {
        case 0:
            return {o, random_in(around, rng) - o};
        case 1:
            return {o, along};
        case 2:
            return {triangle.a - T(100) * along, along};  // grazes boxes that touch this vertex
        case 3:
            return {o, triangle.a + u * (triangle.b - triangle.a) - o};
        case 4:
            return {o, triangle.c - o};
        default:
            return {triangle.a + u * (triangle.c - triangle.a), random_in(around, rng) - o};
    }
}

/// Thin, tiny, flat, coinciding and far away: triangles nobody should make, each of them twice.
template <class T>
Mesh<T> terrible_mesh() {
    Mesh<T> mesh;
    Rng     rng{3, 1, 4, 1};
    for (std::uint32_t i = 0; i < 120; ++i) {
        Box<T>     box{Vector3<T>(-1), Vector3<T>(1)};
        const auto a = random_in(box, rng), b = random_in(box, rng), c = random_in(box, rng);
        const T    small[] = {T(1), T(1e-3), T(1e-6), T(0)};
        mesh.vertices.insert(mesh.vertices.end(), {a, b, a + small[i % 4] * (c - a)});
        if (i % 5 == 0)
            mesh.vertices.back().z = mesh.vertices[3 * i].z = mesh.vertices[3 * i + 1].z = T(0.25);
        for (int twice = 0; twice < 2; ++twice) mesh.faces.push_back({3 * i, 3 * i + 1, 3 * i + 2});
    }
    return mesh;
}

struct Differences {
    int rays = 0, different = 0, hits = 0;
};

/// @param hierarchy  of the mesh: Hierarchy<T>, MistakenHierarchy
template <class T, class Surfaces>
Differences compare(const Mesh<T>& mesh, const Surfaces& hierarchy, int rays) {
    const BruteForce<T> all(mesh);
    Box<T>              around = bounds(mesh);
    around.include(around.min - around.size());
    around.include(around.max + around.size());

    std::atomic<int> different = 0, hits = 0;
    const int        side = int(std::sqrt(double(rays)));
    for_each_pixel(side, side, {.threads = 0}, [&](int x, int y) {
        Rng        rng{5, std::uint32_t(x), std::uint32_t(y), 0};
        const auto ray      = awkward_ray(mesh, around, rng);
        const auto expected = all.nearest(ray);
        if (!(hierarchy.nearest(ray) == expected)) ++different;
        if (hierarchy.occluded(ray) != expected.has_value()) ++different;
        // The range's ends belong to it: up to the hit it is found, just before it none, just beyond another.
        if (expected) {
            ++hits;
            if (!(hierarchy.nearest(ray, {0, expected->t}) == expected)) ++different;
            const Interval<T> before{0, std::nextafter(expected->t, T(0))};
            const Interval<T> beyond{std::nextafter(expected->t, expected->t + 1), in_front<T>.max};
            for (const auto& range : {before, beyond}) {
                if (!(hierarchy.nearest(ray, range) == all.nearest(ray, range))) ++different;
            }
        }
    });
    return {side * side, different, hits};
}

}  // namespace

TEST_CASE("every hierarchy equals brute force to the bit, on a million rays in all") {
    for (const Cut cut : {Cut::median, Cut::binned, Cut::swept}) {
        CAPTURE(int(cut));
        Differences sum;
        for (const auto& [mesh, rays] : {std::pair{convert<float>(cornell_box().mesh), 300 * 300},
                                         {convert<float>(teapot(2)), 400 * 400},
                                         {terrible_mesh<float>(), 300 * 300}}) {
            const auto found = compare(mesh, Hierarchy<float>(mesh, {.cut = cut, .asked_straight = 0}), rays);
            CHECK(found.different == 0);
            CHECK(found.hits >= found.rays / 5);
            sum.rays += found.rays;
        }
        CHECK(sum.rays >= 300'000);
    }
}

TEST_CASE("triangles that are asked straight need no box, and answer the same") {
    const auto             mesh = convert<float>(cornell_box().mesh);
    const Hierarchy<float> straight(mesh, {.asked_straight = std::uint32_t(mesh.faces.size())});
    CHECK(straight.tree().nodes.empty());
    CHECK(compare(mesh, straight, 100 * 100).different == 0);
    const auto fewer = std::uint32_t(mesh.faces.size() - 1);
    CHECK(!Hierarchy<float>(mesh, {.asked_straight = fewer}).tree().nodes.empty());
}

TEST_CASE_TEMPLATE("packs of eight triangles find what brute force finds, to a rounding of t", T, float,
                   double) {
    for (const auto& mesh : {convert<T>(cornell_box().mesh), convert<T>(teapot(1)), terrible_mesh<T>()}) {
        const TrianglePacks<T> packs(mesh);
        const BruteForce<T>    all(mesh);
        const Box<T>           around = bounds(mesh);
        int                    hits = 0, other_face = 0, wrong = 0;
        for (std::uint32_t i = 0; i < 40'000; ++i) {
            Rng        rng{7, i, 0, 0};
            const auto ray      = awkward_ray(mesh, around, rng);
            const auto expected = all.nearest(ray), found = packs.nearest(ray);
            wrong += packs.occluded(ray) == found.has_value() ? 0 : 1;
            wrong += expected.has_value() == found.has_value() ? 0 : 1;
            if (!expected || !found) continue;
            ++hits;
            const T size     = std::max({size_of(ray.origin), size_of(around.min), size_of(around.max)});
            const T rounding = 4 * std::numeric_limits<T>::epsilon() * size / length(ray.direction);
            wrong += std::abs(found->t - expected->t) <= rounding ? 0 : 1;
            if (found->face == expected->face)
                wrong += found->uv == expected->uv ? 0 : 1;
            else
                ++other_face;  // of two at the same place
            // the range's ends belong to it
            wrong += packs.nearest(ray, {0, found->t}) == found ? 0 : 1;
            const auto before = packs.nearest(ray, {0, std::nextafter(found->t, T(0))});
            wrong += before && found->t > 0 && !(before->t < found->t) ? 1 : 0;
        }
        CHECK(wrong == 0);
        CHECK(hits > 8000);
        CHECK(other_face < hits / 20);  // most where each triangle is there twice
    }
    CHECK_FALSE(TrianglePacks<T>(Mesh<T>{}).nearest({{0, 0, 0}, {0, 0, 1}}));
}

TEST_CASE("these rays find a hierarchy that is wrong only at a tie or by a rounding") {
    for (const auto& mesh : {convert<float>(cornell_box().mesh), terrible_mesh<float>()}) {
        const auto different = [&](Mistake mistake) {
            return compare(mesh, MistakenHierarchy(mesh, mistake), 200 * 200).different;
        };
        CHECK(different(Mistake::none) == 0);
        CHECK(different(Mistake::strict_pruning) >= 100);
        CHECK(different(Mistake::thin_boxes) >= 100);
        CHECK(different(Mistake::higher_face) >= 100);
    }
}

TEST_CASE("the hierarchy equals brute force to the bit in double") {
    for (const auto& mesh : {teapot(2), terrible_mesh<double>()}) {
        for (const Cut cut : {Cut::median, Cut::binned, Cut::swept})
            CHECK(compare(mesh, Hierarchy<double>(mesh, {.cut = cut}), 150 * 150).different == 0);
    }
}

TEST_CASE("at equal t the lower face wins, in whatever order the triangles are kept") {
    auto mesh = convert<float>(teapot(3));
    for (std::size_t i = 0, count = mesh.faces.size(); i < count; ++i) mesh.faces.push_back(mesh.faces[i]);
    const Hierarchy<float> hierarchy(mesh);
    const auto             around = bounds(mesh);
    int                    hits   = 0;
    for (std::uint32_t i = 0; i < 2000; ++i) {
        Rng        rng{1, i, 0, 0};
        const Vec3 o   = random_in(around, rng) + Vec3{0, 0, 10};
        const auto hit = hierarchy.nearest(Ray<float>{o, {0, 0, -1}});
        if (!hit) continue;
        ++hits;
        CHECK(hit->face < mesh.faces.size() / 2);
    }
    CHECK(hits >= 500);
}

TEST_CASE("meshes without a good cut: none, one, and a thousand triangles in one place") {
    const Ray<float> ray{{0.25F, 0.25F, 1}, {0, 0, -1}};
    Mesh<float>      mesh;
    CHECK(!Hierarchy<float>(mesh).nearest(ray));
    mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    mesh.faces    = {{0, 1, 2}};
    REQUIRE(Hierarchy<float>(mesh).nearest(ray));
    mesh.faces.assign(1000, {0, 1, 2});
    for (const Cut cut : {Cut::median, Cut::binned, Cut::swept}) {
        const auto hit = Hierarchy<float>(mesh, {.cut = cut}).nearest(ray);
        REQUIRE(hit);
        CHECK(hit->face == 0);
        CHECK(hit->t == 1);
    }
}

TEST_CASE("a staircase of boxes does not make the tree too deep to walk") {
    // Each triangle is ten times as far away as the last: every cut takes off one.
    Mesh<double> mesh;
    for (std::uint32_t i = 0; i < 300; ++i) {
        const double s = std::pow(10.0, double(i) - 150);
        mesh.vertices.insert(mesh.vertices.end(), {{0, 0, s}, {s, 0, s}, {0, s, s}});
        mesh.faces.push_back({3 * i, 3 * i + 1, 3 * i + 2});
    }
    for (const Cut cut : {Cut::median, Cut::binned, Cut::swept}) {
        const Hierarchy<double> hierarchy(mesh, {.cut = cut});
        for (const double x : {1e-140, 1e-3, 1e100}) {
            const Ray<double> ray{{x, x, 0}, {0, 0, 1}};
            CHECK(hierarchy.nearest(ray) == BruteForce<double>(mesh).nearest(ray));
        }
    }
}

TEST_CASE("a ray that is not a number hits nothing, and comes to an end") {
    const float nan      = std::numeric_limits<float>::quiet_NaN(),
                infinity = std::numeric_limits<float>::infinity();
    const Mesh<float> one{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}};
    for (const Mesh<float>& mesh : {Mesh<float>{}, one, convert<float>(teapot(3))}) {
        const Hierarchy<float> hierarchy(mesh);
        for (const Ray<float>& ray : {Ray<float>{{nan, 0, 0}, {0, 0, 1}},
                                      {{0, 0, 0}, {nan, nan, nan}},
                                      {{0, 0, -9}, {0, 0, infinity}},
                                      {{infinity, 0, 0}, {-1, 0, 0}},
                                      {{0, 0, 0}, {0, 0, 0}}}) {
            CHECK(!hierarchy.nearest(ray));
            CHECK(!hierarchy.occluded(ray));
            CHECK(!TrianglePacks<float>(mesh).nearest(ray));
            CHECK(!BruteForce<float>(mesh).nearest(ray));
        }
    }
}

TEST_CASE("laws of hierarchies: any bits as triangles and rays are answered as by brute force") {
    test::check_law("each way of cutting equals brute force", [] {
        Mesh<float> mesh;
        const auto  count = *rc::gen::inRange<std::uint32_t>(1, 20);
        for (std::uint32_t i = 0; i < count; ++i) {
            for (int k = 0; k < 3; ++k) mesh.vertices.push_back(test::vector_of(test::any_bits<float>()));
            mesh.faces.push_back({3 * i, 3 * i + 1, 3 * i + 2});
        }
        const Ray<float> ray{test::vector_of(test::any_bits<float>()),
                             test::vector_of(test::any_bits<float>())};
        const auto       expected = BruteForce<float>(mesh).nearest(ray);
        RC_ASSERT((!expected || std::isfinite(expected->t)));
        for (const Cut cut : {Cut::median, Cut::binned, Cut::swept}) {
            const Hierarchy<float> hierarchy(mesh, {.cut = cut, .asked_straight = 0});
            RC_ASSERT(hierarchy.nearest(ray) == expected);
            RC_ASSERT(hierarchy.occluded(ray) == expected.has_value());
        }
    });
}

TEST_CASE("the expected work is the ratio of surfaces: a cube cut in two, by hand") {
    // Two pairs of unit squares at the ends of a row of three cubes: the whole has 14 unit squares of surface.
    Mesh<float> mesh;
    for (const float x : {0.0F, 2.0F}) {
        const auto first = std::uint32_t(mesh.vertices.size());
        mesh.vertices.insert(mesh.vertices.end(), {{x, 0, 0}, {x + 1, 1, 0}, {x, 1, 1}, {x + 1, 0, 1}});
        for (std::uint32_t i = 0; i < 4; ++i)
            mesh.faces.push_back({first + i, first + (i + 1) % 4, first + (i + 2) % 4});
    }
    // The root is met, and both its leaves, unit cubes of four triangles each, with chance 6 / 14.
    const auto work = expected_work(Hierarchy<float>(mesh, {.cut = Cut::median, .asked_straight = 0}).tree());
    CHECK(work.nodes == 1);
    CHECK(std::abs(work.triangles - 2 * 4 * 6.0 / 14) <= 1e-6);
    CHECK(expected_work(Hierarchy<float>(mesh, {.asked_straight = 8}).tree()).triangles == 8);
}

TEST_CASE("a walk that is counted says how many nodes and triangles it took") {
    const auto             mesh = convert<float>(teapot(4));
    const Hierarchy<float> hierarchy(mesh);
    const Ray<float>       ray{{0, -10, 1}, {0, 1, 0}}, away{{0, -10, 1}, {0, -1, 0}};
    WalkCount              count;
    CHECK(hierarchy.nearest(ray, in_front<float>, count) == hierarchy.nearest(ray));
    CHECK(count.nodes >= 5);
    CHECK(count.nodes < hierarchy.tree().nodes.size() / 4);
    CHECK(count.triangles >= 1);
    CHECK(count.triangles < mesh.faces.size() / 4);
    WalkCount none;
    CHECK(!hierarchy.nearest(away, in_front<float>, none));
    CHECK(none.nodes == 0);
    CHECK(none.triangles == 0);
    WalkCount straight;
    CHECK(!Hierarchy<float>(mesh, {.asked_straight = 1'000'000}).nearest(away, in_front<float>, straight));
    CHECK(straight.triangles == mesh.faces.size());
}

TEST_CASE(
    "the nearer child goes first: of walls one behind the other, a ray asks those around the first only") {
    Mesh<float> walls;
    for (std::uint32_t i = 0; i < 64; ++i) {
        const auto z = float(i);
        walls.vertices.insert(walls.vertices.end(), {{-1, -1, z}, {3, -1, z}, {-1, 3, z}});
        walls.faces.push_back({3 * i, 3 * i + 1, 3 * i + 2});
    }
    // Sixteen leaves of four walls, four nodes below the root's. From both sides: neither child is always first.
    const Hierarchy<float> hierarchy(walls, {.cut = Cut::median});
    for (const Ray<float>& ray : {Ray<float>{{0, 0, -1}, {0, 0, 1}}, {{0, 0, 64}, {0, 0, -1}}}) {
        WalkCount count;
        REQUIRE(hierarchy.nearest(ray, in_front<float>, count));
        CHECK(count.nodes == 4);
        CHECK(count.triangles == 4);
    }
}

TEST_CASE("by the cost that they minimise, sweeping is no worse than bins, and bins are better than halves") {
    const auto mesh = convert<float>(teapot(8));
    const auto cost = [&](Cut cut) {
        return expected_work(Hierarchy<float>(mesh, {.cut = cut}).tree()).cost();
    };
    CHECK(cost(Cut::swept) < 1.02 * cost(Cut::binned));
    CHECK(cost(Cut::binned) < 0.9 * cost(Cut::median));
}

TEST_CASE("triangles on a line make boxes without a surface, which nobody meets: no work, and not NaN") {
    Mesh<float> line;
    for (std::uint32_t i = 0; i < 10; ++i) {
        const auto x = float(i);
        line.vertices.insert(line.vertices.end(), {{x, 0, 0}, {x + 1, 0, 0}, {x + 2, 0, 0}});
        line.faces.push_back({3 * i, 3 * i + 1, 3 * i + 2});
    }
    const auto work = expected_work(Hierarchy<float>(line, {.cut = Cut::median, .asked_straight = 0}).tree());
    CHECK(work.nodes == 0);
    CHECK(work.triangles == 0);
}
