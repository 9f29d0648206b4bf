/// @file triangle_laws.cpp
/// What holds for the watertight test whatever the numbers; and that it does not hold for the textbook's.

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <limits>

#include "geometry/moeller_trumbore.hpp"
#include "geometry/triangle.hpp"
#include "law.hpp"
#include "sampling/rng.hpp"
#include "vector_of.hpp"

using namespace sr;
using namespace sr::test;

namespace {

template <class T>
Triangle<T> any_triangle() {
    const auto a = vector_of(finite<T>()), b = vector_of(finite<T>()), c = vector_of(finite<T>());
    return {a, b, c};
}

/// A ray to a point of the triangle, as nearly as T says; half of them to one of an edge.
template <class T>
Ray<T> ray_at(const Triangle<T>& triangle) {
    const auto origin = vector_of(finite<T>());
    const T    b1     = T(*rc::gen::inRange(0, 17)) / 16;
    const T    b2     = *rc::gen::arbitrary<bool>() ? T(0) : (1 - b1) * T(*rc::gen::inRange(0, 17)) / 16;
    return {origin, (1 - b1 - b2) * triangle.a + b1 * triangle.b + b2 * triangle.c - origin};
}

template <class T>
constexpr Interval<T> on_the_line{-std::numeric_limits<T>::max(), std::numeric_limits<T>::max()};

/// Of the four faces of a tetrahedron, how many the ray's line meets.
template <class T>
int faces_met(const std::array<Vector3<T>, 4>& p, const auto& intersect) {
    const Triangle<T> faces[] = {
        {p[0], p[1], p[2]}, {p[0], p[3], p[1]}, {p[1], p[3], p[2]}, {p[2], p[3], p[0]}};
    int met = 0;
    for (const auto& face : faces) met += intersect(face).has_value() ? 1 : 0;
    return met;
}

}  // namespace

TEST_CASE_TEMPLATE("the vertices' order changes neither whether a triangle is hit nor where", T, float,
                   double) {
    check_law("a permutation gives the same hit", [] {
        const auto triangle          = any_triangle<T>();
        const auto& [a, b, c]        = triangle;
        constexpr T          epsilon = std::numeric_limits<T>::epsilon();
        const Ray<T>         seen    = ray_at(triangle);
        const TriangleRay<T> ray(seen);
        const auto           hit = ray.intersect(triangle, on_the_line<T>);
        const T size = std::max({length(a - seen.origin), length(b - seen.origin), length(c - seen.origin)});
        for (const Triangle<T>& turned : {Triangle<T>{b, c, a}, {c, a, b}, {a, c, b}, {c, b, a}, {b, a, c}}) {
            const auto same = ray.intersect(turned, on_the_line<T>);
            RC_ASSERT(same.has_value() == hit.has_value());
            if (!hit) continue;
            // Depths are weighted and summed in another order: a few roundings of the farthest vertex.
            RC_ASSERT(std::abs(same->t - hit->t) * length(seen.direction) <= 16 * epsilon * size);
        }
    });
}

TEST_CASE_TEMPLATE("a power of two changes no digit of a hit", T, float, double) {
    check_law("the scene scaled: the same hit; the direction scaled: t scaled back", [] {
        const auto triangle = any_triangle<T>();
        const auto ray      = ray_at(triangle);
        const T    scale    = std::ldexp(T(1), *rc::gen::inRange(-8, 9));
        const auto hit      = TriangleRay<T>(ray).intersect(triangle, on_the_line<T>);

        const Triangle<T> larger{scale * triangle.a, scale * triangle.b, scale * triangle.c};
        const auto        scene =
            TriangleRay<T>({scale * ray.origin, scale * ray.direction}).intersect(larger, on_the_line<T>);
        const auto along =
            TriangleRay<T>({ray.origin, scale * ray.direction}).intersect(triangle, on_the_line<T>);
        RC_ASSERT(scene.has_value() == hit.has_value());
        RC_ASSERT(along.has_value() == hit.has_value());
        if (!hit) return;
        RC_ASSERT((scene->t == hit->t && scene->uv == hit->uv));
        RC_ASSERT((along->t == hit->t / scale && along->uv == hit->uv));
    });
}

TEST_CASE_TEMPLATE("a hit's weights name a point of the triangle that is on the ray", T, float, double) {
    check_law("weights are in the triangle, and their point is on the ray", [] {
        const auto triangle = any_triangle<T>();
        const auto ray      = ray_at(triangle);
        const auto hit      = TriangleRay<T>(ray).intersect(triangle, on_the_line<T>);
        RC_PRE(hit.has_value());
        constexpr T epsilon = std::numeric_limits<T>::epsilon();
        const auto [u, v]   = std::pair{hit->uv.x, hit->uv.y};
        RC_ASSERT((u >= 0 && v >= 0 && u + v <= 1 + 2 * epsilon));

        // In double; the bound is for the rounding of each vertex as it is seen from the origin along the ray.
        const Vector3<double> o(ray.origin), d(ray.direction), a(triangle.a), b(triangle.b), c(triangle.c);
        const auto            p    = a + double(u) * (b - a) + double(v) * (c - a);
        const double          size = std::max({length(a - o), length(b - o), length(c - o)});
        RC_ASSERT(length(cross(p - o, d)) <= 16 * double(epsilon) * size * length(d));
    });
}

TEST_CASE_TEMPLATE("a line that enters a tetrahedron leaves it", T, float, double) {
    // Whatever the rounding: two faces that share an edge agree on which side of it the line passes. So the line can't
    // meet one face alone, not even of a tetrahedron that is flat, nor along a face or through a vertex.
    const auto tetrahedron = [] {
        return std::array{vector_of(finite<T>()), vector_of(finite<T>()), vector_of(finite<T>()),
                          vector_of(finite<T>())};
    };
    check_law("no line meets one face alone", [&] {
        const auto           p   = tetrahedron();
        const auto           ray = ray_at(Triangle<T>{p[0], p[1], p[2]});
        const TriangleRay<T> triangles(ray);
        RC_ASSERT(faces_met(p, [&](const auto& face) { return triangles.intersect(face, on_the_line<T>); }) !=
                  1);
    });
}

TEST_CASE_TEMPLATE("by the textbook's test a line gets stuck in a tetrahedron", T, float, double) {
    Rng        rng{5, 0, 0, 0};
    const auto point = [&] {
        const T x = rng.uniform<T>(), y = rng.uniform<T>(), z = rng.uniform<T>();
        return Vector3<T>{x, y, z};
    };
    int stuck = 0;
    for (int i = 0; i < 2000; ++i) {
        const std::array p{point(), point(), point(), point()};
        const auto       origin = point();
        const T          u      = rng.uniform<T>();
        const Ray<T>     ray{origin, p[0] + u * (p[1] - p[0]) - origin};
        const int        met = faces_met(
                   p, [&](const auto& face) { return intersect_moeller_trumbore(face, ray, on_the_line<T>); });
        stuck += met == 1 ? 1 : 0;
    }
    CHECK(stuck >= 100);
}
