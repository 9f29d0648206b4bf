#include "scene/rasteriser.hpp"

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <type_traits>

#include "geometry/hierarchy.hpp"
#include "math/difference_of_products.hpp"
#include "sampling/rng.hpp"
#include "scene/cornell_box.hpp"
#include "scene/teapot.hpp"
#include "scene/visibility_difference.hpp"
#include "transport/primary.hpp"
#include "transport/swapped_loops.hpp"

using namespace sr;

namespace {

struct View {
    Mesh<double>   mesh;
    Camera<double> camera;
};

View cornell(int side) {
    return {cornell_box().mesh, cornell_box_camera(side)};
}

View pot(int level, Vector3<double> eye) {
    const Vector3<double> target{0.2, 0, 1.4};
    return {teapot(level), pinhole_camera<double>(eye, target - eye, {0, 0, 1}, 1.0, 0.8, 320, 240)};
}

/// The two images of a view in the precision T, counted pixel by pixel.
template <class T>
VisibilityDifference compare(const View& view) {
    return compare_swapped_loops<T>(view.mesh, view.camera, {.threads = 0});
}

View in_camera_space(const View& view) {
    return {to_camera_space(view.mesh, view.camera), sr::in_camera_space(view.camera)};
}

/// p x q, accurate, but not to the bit the negative of q x p.
Vector3<double> one_sided_cross(Vector3<double> p, Vector3<double> q) {
    return {difference_of_products(p.y, q.z, p.z, q.y), difference_of_products(p.z, q.x, p.x, q.z),
            difference_of_products(p.x, q.y, p.y, q.x)};
}

/// Whether d meets the triangle, as TriangleSetup would say with that cross product: what loses pixels.
bool one_sided_covers(const Triangle<double>& seen, Vector3<double> d) {
    const auto& [a, b, c] = seen;
    const double side     = dot(a, one_sided_cross(b, c)) < 0 ? -1 : 1;
    return side * dot(one_sided_cross(b, c), d) >= 0 && side * dot(one_sided_cross(c, a), d) >= 0 &&
           side * dot(one_sided_cross(a, b), d) >= 0;
}

}  // namespace

TEST_CASE_TEMPLATE("rasteriser and ray tracer see the same, to the triangle", T, float, double) {
    for (const View& view :
         {cornell(300), pot(4, {4, -7, 4.5}), pot(12, {-6, -4, 3}), pot(12, {0, 0.001, 9})}) {
        const auto world = compare<T>(view);
        CHECK(world.pixels == view.camera.width * view.camera.height);
        CHECK(world.hit >= 10'000);
        CHECK(world.hit_or_missed == 0);
        CHECK(world.unexplained == 0);
        CHECK(world.at_edge + world.at_tie == world.other_triangle);
        // With the camera in the origin no digit is lost on the way to either, and nothing is left to explain.
        const auto moved = compare<T>(in_camera_space(view));
        CHECK(moved.hit_or_missed == 0);
        CHECK(moved.other_triangle == 0);
    }
}

TEST_CASE("the comparison notices a camera that is off by a hundredth of a pixel") {
    const auto             view   = pot(12, {4, -7, 4.5});
    const auto             mesh   = convert<float>(view.mesh);
    const auto             camera = convert<float>(view.camera);
    const Hierarchy<float> hierarchy(mesh);
    VisibilityImage<float> shifted(camera.width, camera.height);
    for_each_pixel(camera.width, camera.height, {}, [&](int x, int y) {
        const auto hit = hierarchy.nearest(camera.ray({float(x) + 0.51F, float(y) + 0.5F}));
        if (hit) shifted(x, y) = {hit->t, hit->face};
    });
    const auto difference = compare_visibility(shifted, rasterise(mesh, camera), mesh, camera);
    CHECK(difference.hit_or_missed >= 1);
    CHECK(difference.unexplained >= 10);
}

TEST_CASE("a pixel that names another triangle is counted by its excuse") {
    // Two triangles in one place and a third one beside them, whose edge x = side ends in the pixel's centre.
    const auto camera = pinhole_camera<double>({0, 0, 0}, {0, 0, 1}, {0, 1, 0}, 1.0, 1.0, 1, 1);
    const auto differ = [&](double side, double t) {
        const Mesh<double>  mesh{{{-9, -9, 1}, {9, -9, 1}, {0, 9, 1}, {side, -9, 1}, {side, 9, 1}, {9, 0, 1}},
                                {{0, 1, 2}, {0, 1, 2}, {3, 4, 5}}};
        const std::uint32_t other = side < 1 ? 2 : 1;
        VisibilityImage<double> one(1, 1), two(1, 1);
        one(0, 0)    = {1, 0};
        two(0, 0)    = {t, other};
        const auto d = compare_visibility(one, two, mesh, camera);
        CHECK(d.other_triangle == 1);
        return std::array{d.at_edge, d.at_tie, d.unexplained};
    };
    CHECK(differ(9e-6, 2) == std::array{1, 0, 0});
    CHECK(differ(1.1e-5, 2) == std::array{0, 0, 1});
    CHECK(differ(1, 1 + 9e-7) == std::array{0, 1, 0});
    CHECK(differ(1, 1 - 1.1e-6) == std::array{0, 0, 1});
    CHECK(differ(1, std::nan("")) == std::array{0, 0, 1});
}

TEST_CASE("a triangle that reaches behind the camera is drawn where rays meet it") {
    const Mesh<float> floor{{{-50, -1, -50}, {50, -1, -50}, {0, -1, 80}}, {{0, 1, 2}}};
    const auto        camera =
        convert<float>(pinhole_camera<double>({0, 0, 0}, {0, 0, 1}, {0, 1, 0}, 1.0, 1.0, 64, 64));
    const auto difference = compare_visibility(trace_primary(BruteForce<float>(floor), camera),
                                               rasterise(floor, camera), floor, camera);
    CHECK(difference.hit >= 1000);
    CHECK(difference.hit_or_missed == 0);
}

TEST_CASE("at equal t the lower face is drawn") {
    Mesh<float> mesh{{{-1, -1, 5}, {1, -1, 5}, {0, 1, 5}}, {{0, 1, 2}, {1, 2, 0}}};
    const auto  camera =
        convert<float>(pinhole_camera<double>({0, 0, 0}, {0, 0, 1}, {0, 1, 0}, 1.0, 1.0, 32, 32));
    const auto image = rasterise(mesh, camera);
    int        drawn = 0;
    for (const auto& pixel : image.pixels()) {
        if (!pixel.hit()) continue;
        ++drawn;
        CHECK(pixel.face == 0);
    }
    CHECK(drawn >= 30);
}

TEST_CASE_TEMPLATE("no pixel is lost between two triangles whose edge goes through its centre", T, float,
                   double) {
    // Pairs of triangles on both sides of an edge, the edge's ends on the line that one pixel's ray spans.
    const auto camera =
        in_camera_space(convert<T>(pinhole_camera<double>({0, 0, 0}, {0, 0, 1}, {0, 1, 0}, 1.0, 1.0, 8, 8)));
    int lost = 0, lost_one_sided = 0, seen = 0;
    for (int i = 0; i < 20'000; ++i) {
        Rng        rng{11, i, 0, 0};
        const auto random = [&] { return rng.uniform<T>() - T(0.5); };
        const int  x = i % 8, y = i / 8 % 8;
        const auto d    = camera.ray_through_pixel(x, y).direction;
        const T    near = T(0.5) + rng.uniform<T>(), s = T(3) * random(), u = T(3) * random(),
                v = T(3) * random(), w = T(3) * random();
        const Vector3<T> a = near * d + Vector3<T>{s, u, v}, b = near * d - w * Vector3<T>{s, u, v};
        const Vector3<T> aside = T(4) * normalize(cross(d, a - b));
        const Mesh<T>    mesh{{a, b, near * d + aside, near * d - aside}, {{0, 1, 2}, {1, 0, 3}}};
        if (!BruteForce<T>(mesh).nearest(camera.ray_through_pixel(x, y))) continue;  // beyond the edge's ends
        ++seen;
        lost += rasterise(mesh, camera)(x, y).hit() ? 0 : 1;
        const auto exact = convert<double>(mesh);
        lost_one_sided +=
            one_sided_covers(exact.triangle(0), d) || one_sided_covers(exact.triangle(1), d) ? 0 : 1;
    }
    CHECK(seen >= 5'000);
    CHECK(lost == 0);
    // The product of two floats fits into a double: only of doubles is one rounded, and which one matters.
    CHECK((std::is_same_v<T, float> ? lost_one_sided == 0 : lost_one_sided >= 100));
}
