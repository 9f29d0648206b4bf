/// @file triangle_methods.cpp
/// What holds for every way to intersect a triangle: the right answer, within what rounding allows; and a finite hit
/// or none for any bits.

#include "triangle_methods.hpp"

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <limits>

#include "law.hpp"
#include "sampling/rng.hpp"

using namespace sr;
using namespace sr::test;

namespace {

/// A ray and a triangle of which the hit is known.
struct Known {
    Triangle<double> triangle;
    Ray<double>      ray;
    double           t, b1, b2;
};

/// How much rounding of the data alone can move the solution x of M x = s, per unit of relative error: |M^-1| (|M| |x|
/// + |s|), for M = (-d, e1, e2). (Skeel 1979; Higham, Accuracy and Stability of Numerical Algorithms, chapter 7.)
Vector3<double> condition(const Known& known) {
    const auto& [a, b, c]    = known.triangle;
    const auto            e1 = b - a, e2 = c - a, s = known.ray.origin - a, d = known.ray.direction;
    const double          determinant = dot(cross(d, e2), e1);
    const Vector3<double> rows[]      = {cross(e1, e2), cross(d, e2),
                                         cross(e1, d)};  // of M^-1, times +-determinant
    const auto            changed =
        glm::abs(d) * known.t + glm::abs(e1) * known.b1 + glm::abs(e2) * known.b2 + glm::abs(s);
    Vector3<double> result;
    for (glm::length_t i = 0; i < 3; ++i) result[i] = dot(glm::abs(rows[i]), changed) / std::abs(determinant);
    return result;
}

template <class T>
void check_hit(const Known& known, const auto& intersect) {
    const auto& [a, b, c] = known.triangle;
    const Triangle<T> triangle{Vector3<T>(a), Vector3<T>(b), Vector3<T>(c)};
    const Ray<T>      ray{Vector3<T>(known.ray.origin), Vector3<T>(known.ray.direction)};
    const auto        hit = intersect(triangle, ray, in_front<T>);
    REQUIRE(hit);
    const auto bound = 8.0 * double(std::numeric_limits<T>::epsilon()) * condition(known);
    CHECK(std::abs(double(hit->t) - known.t) <= bound.x);
    CHECK(std::abs(double(hit->uv.x) - known.b1) <= bound.y);
    CHECK(std::abs(double(hit->uv.y) - known.b2) <= bound.z);
}

/// A triangle with whole coordinates and a ray to the point of it with the weights b1, b2, multiples of 1/16: the
/// float data are exact, and t = 1.
Known on_a_grid(Rng& rng) {
    const auto whole = [&] { return std::floor(rng.uniform<double>() * 201) - 100; };
    const auto point = [&] {
        const double x = whole(), y = whole(), z = whole();
        return Vector3<double>{x, y, z};
    };
    const Triangle<double> triangle{point(), point(), point()};
    const double           b1 = std::floor(1 + rng.uniform<double>() * 14) / 16;
    const double           b2 = std::floor(1 + rng.uniform<double>() * (15 - 16 * b1)) / 16;
    const auto             p  = triangle.a + b1 * (triangle.b - triangle.a) + b2 * (triangle.c - triangle.a);
    const auto             origin = point();
    return {triangle, {origin, p - origin}, 1, b1, b2};
}

/// Whether the ray is seen from so little of the side, or the triangle is so thin, that nothing is to be asked of it.
bool is_edge_on(const Known& known) {
    const auto n = area_vector(known.triangle);
    return std::abs(dot(n, known.ray.direction)) < 0.01 * length(n) * length(known.ray.direction) ||
           length(n) < 100;
}

}  // namespace

TEST_CASE_TEMPLATE("G2 all methods: exact rational t, b1, b2", T, float, double) {
    // Of both, (b - a, c - a, -d) (b1, b2, t)^T = o - a is solved in fractions: 90/31, 37/124, 49/124; and 5, 1/4, 1/2.
    const Known first{
        {{-1, -1, 2}, {2, -1, 3}, {0, 3, 1}}, {{0, 0, -1}, {0.1, 0.2, 1}}, 90 / 31.0, 37 / 124.0, 49 / 124.0};
    const Known second{{{-1, -1, 0}, {1, -1, 0}, {0, 1, 0}}, {{0, 0, 5}, {0, 0, -1}}, 5, 0.25, 0.5};
    for_each_triangle_method<T>([&](const char* name, const auto& intersect) {
        CAPTURE(name);
        check_hit<T>(first, intersect);
        check_hit<T>(second, intersect);
    });
}

TEST_CASE_TEMPLATE(
    "all methods: t, b1 and b2 of 20 000 triangles, within 8 units in the last place times the condition", T,
    float, double) {
    for_each_triangle_method<T>([&](const char* name, const auto& intersect) {
        CAPTURE(name);
        Rng rng{3, 0, 0, 0};
        for (int asked = 0; asked < 20'000;) {
            const Known known = on_a_grid(rng);
            if (is_edge_on(known)) continue;
            ++asked;
            check_hit<T>(known, intersect);
        }
    });
}

TEST_CASE_TEMPLATE("all methods: a finite hit or none, whatever the bits", T, float, double) {
    const auto point = [] { return Vector3<T>{*any_bits<T>(), *any_bits<T>(), *any_bits<T>()}; };
    for_each_triangle_method<T>([&](const char* name, const auto& intersect) {
        check_law(
            name,
            [&] {
                const Vector3<T> a = point(), b = point(), c = point(), origin = point(), direction = point();
                const Interval<T> range{*any_bits<T>(), *any_bits<T>()};
                for (const auto& asked : {range, in_front<T>}) {
                    const auto hit = intersect({a, b, c}, {origin, direction}, asked);
                    if (!hit) continue;
                    RC_ASSERT((std::isfinite(hit->t) && asked.contains(hit->t)));
                    RC_ASSERT((hit->uv.x >= 0 && hit->uv.x <= 1 && hit->uv.y >= 0 && hit->uv.y <= 1));
                }
            },
            20'000);
    });
}

TEST_CASE_TEMPLATE("all methods: what overflows is no hit at infinity and none at 0", T, float, double) {
    const T           large = std::numeric_limits<T>::max(), tiny = std::numeric_limits<T>::denorm_min();
    // The hit is at t = 1 / tiny, which no T holds.
    const Triangle<T> ahead{{-1, -1, 1}, {1, -1, 1}, {0, 1, 1}};
    // Seen from the origin, each edge function is finite and their sum is not.
    const T           side = std::sqrt(large) * T(1.22);
    const Triangle<T> wide{{-side, -side, T(0.125)}, {side, -side, T(0.125)}, {0, side, T(0.125)}};
    for_each_triangle_method<T>([&](const char* name, const auto& intersect) {
        CAPTURE(name);
        CHECK(!intersect(ahead, {{0, 0, 0}, {0, 0, tiny}}, in_front<T>));
        const auto hit = intersect(wide, {{0, 0, 0}, {0, 0, 1}}, in_front<T>);
        CHECK((!hit || hit->t == T(0.125)));
    });
}

TEST_CASE_TEMPLATE("all methods: a direction may be the shortest that there is", T, float, double) {
    const T           z = T(0x1p-60), d = 512 * std::numeric_limits<T>::denorm_min();
    const Triangle<T> triangle{{-1, -1, z}, {1, -1, z}, {0, 1, z}};
    for_each_triangle_method<T>([&](const char* name, const auto& intersect) {
        CAPTURE(name);
        const auto hit = intersect(triangle, {{0, 0, 0}, {0, 0, d}}, in_front<T>);
        REQUIRE(hit);
        CHECK(hit->t == z / d);
    });
}
