/// @file offset.cpp
/// A ray that leaves a surface does not meet it again, and meets what is close to it: at every scale, where
/// neither a small epsilon nor a large one can do both.

#include "geometry/offset.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <type_traits>

#include "law.hpp"
#include "math/frame.hpp"
#include "sampling/ball.hpp"
#include "sampling/rng.hpp"
#include "vector_of.hpp"

using namespace sr;
using namespace sr::test;

namespace {

using Exact = Vector3<double>;

/// A surface of some kind within four scales of the origin, and a point of it to aim at.
template <class Shape>
struct Target {
    Shape shape;
    Exact aim;
};

template <std::floating_point T>
Target<Sphere<T>> some_sphere(double scale, Rng& rng) {
    const Sphere<T> sphere{Vector3<T>(3 * scale * in_unit_ball<double>(rng)),
                           T(scale * (0.1 + rng.uniform()))};
    return {sphere, Exact(sphere.centre) + double(sphere.radius) * in_unit_ball<double>(rng)};
}
template <std::floating_point T>
Target<Plane<T>> some_plane(double scale, Rng& rng) {
    const Plane<T> plane{Vector3<T>(3 * scale * in_unit_ball<double>(rng)),
                         Vector3<T>(in_unit_ball<double>(rng))};
    return {plane, Exact(plane.point) + scale * cross(Exact(plane.normal), in_unit_ball<double>(rng))};
}
/// Every other triangle is a needle a thousand times as long as wide.
template <std::floating_point T>
Target<Triangle<T>> some_triangle(double scale, Rng& rng) {
    const Exact  a = 3 * scale * in_unit_ball<double>(rng), c = a + scale * in_unit_ball<double>(rng);
    const double width = rng.uniform() < 0.5F ? scale : 1e-3 * scale;
    const Exact  b     = a + width * in_unit_ball<double>(rng);
    const double u = rng.uniform<double>(), v = rng.uniform<double>() * (1 - u);
    return {{Vector3<T>(a), Vector3<T>(b), Vector3<T>(c)}, (1 - u - v) * a + u * b + v * c};
}

template <class Shape, std::floating_point T>
std::optional<SurfacePoint<T>> point_hit(const Shape& shape, const Ray<T>& ray) {
    const auto t = intersect(shape, ray);
    return t ? std::optional(surface_point(shape, ray, *t)) : std::nullopt;
}
template <std::floating_point T>
std::optional<SurfacePoint<T>> point_hit(const Triangle<T>& triangle, const Ray<T>& ray) {
    const auto hit = TriangleRay(ray).intersect(triangle, in_front<T>);
    return hit ? std::optional(surface_point(triangle, hit->uv)) : std::nullopt;
}

template <std::floating_point T>
struct Launch {
    Ray<T>      ray;
    Interval<T> range = in_front<T>;
};
template <class Shape, std::floating_point T>
bool meets(const Launch<T>& launch, const Shape& shape) {
    return intersect(shape, launch.ray, launch.range).has_value();
}
template <std::floating_point T>
bool meets(const Launch<T>& launch, const Triangle<T>& triangle) {
    return TriangleRay(launch.ray).intersect(triangle, launch.range).has_value();
}

/// Whether the launched ray meets a wall parallel to the surface, at a thousandth of the scale: as a plane, and as a
/// triangle around the point where the exact ray is. Rays along the wall are not asked.
template <std::floating_point T>
bool meets_wall(const Launch<T>& launch, const SurfacePoint<T>& p, const Vector3<T>& direction,
                double scale) {
    const Exact  n(p.normal), d = normalize(Exact(direction));
    const double cosine = dot(n, d), height = std::copysign(1e-3 * scale, cosine);
    if (std::abs(cosine) < 0.01) return true;
    const Exact foot  = Exact(p.position) + height / cosine * d;
    const auto  frame = frame_around(n);
    const auto  at = [&](double x, double y) { return Vector3<T>(foot + scale * frame.to_world({x, y, 0})); };
    return meets(launch, Plane<T>{at(1, 0), p.normal}) &&
           meets(launch, Triangle<T>{at(2, 0), at(-1, 2), at(-1, -2)});
}

/// A direction to either side of the surface, half of them grazing it at angles down to 10^-6.
template <std::floating_point T>
Vector3<T> some_direction(const Vector3<T>& normal, Rng& rng) {
    const Exact n(normal);
    Exact       d = normalize(in_unit_ball<double>(rng));
    if (rng.uniform() < 0.5F) {
        const double side = std::copysign(std::pow(10.0, -6 * rng.uniform<double>()), dot(d, n));
        d                 = normalize(d - dot(d, n) * n) + side * n;
    }
    return Vector3<T>((0.1 + rng.uniform<double>()) * d);
}

struct Mistakes {
    int rays = 0, self_hits = 0, lost = 0;
};

/// What goes wrong when rays leave such surfaces, from where camera rays hit them.
template <std::floating_point T, class Make, class Leave>
Mistakes mistakes(const Make& make, const Leave& leaving, int rays_per_scale) {
    Mistakes result;
    for (int decade = -4; decade <= 4; ++decade) {
        const double scale = std::pow(10.0, decade);
        for (int i = 0; i < rays_per_scale; ++i) {
            Rng              rng{8, decade, i, 0};
            const auto       target = make(scale, rng);
            const Vector3<T> eye(10 * scale * normalize(in_unit_ball<double>(rng)));
            const auto       p = point_hit(target.shape, Ray<T>{eye, Vector3<T>(target.aim) - eye});
            if (!p) continue;  // aimed past the edge by a rounding
            const Vector3<T> direction = some_direction(p->normal, rng);
            const Launch<T>  launch    = leaving(*p, direction);
            const bool       inwards   = dot(Exact(p->normal), Exact(direction)) < 0;
            const bool       meets_own = meets(launch, target.shape);
            // A sphere's inside is a surface as well: what goes in comes out.
            const bool       other_side = std::is_same_v<decltype(target.shape), Sphere<T>> && inwards;
            ++result.rays;
            result.self_hits += meets_own && !other_side ? 1 : 0;
            result.lost += (other_side && !meets_own) || !meets_wall(launch, *p, direction, scale) ? 1 : 0;
        }
    }
    return result;
}

template <std::floating_point T>
Launch<T> by_error_bound(const SurfacePoint<T>& p, const Vector3<T>& direction) {
    return {leave(p, direction)};
}

/// The textbook's t >= epsilon.
template <std::floating_point T>
auto by_epsilon(T epsilon) {
    return [=](const SurfacePoint<T>& p, const Vector3<T>& direction) {
        return Launch<T>{{p.position, direction}, {epsilon, in_front<T>.max}};
    };
}

/// All three kinds of surface, one after the other.
template <std::floating_point T, class Check>
void for_each_kind(const Check& check) {
    check("sphere", some_sphere<T>);
    check("plane", some_plane<T>);
    check("triangle", some_triangle<T>);
}

}  // namespace

TEST_CASE_TEMPLATE("a million rays leave surfaces of all scales: none meets its own, none loses another", T,
                   float, double) {
    for_each_kind<T>([](const std::string& kind, const auto& make) {
        CAPTURE(kind);
        const Mistakes found = mistakes<T>(make, by_error_bound<T>, 40'000);
        CHECK(found.rays >= 340'000);
        CHECK(found.self_hits == 0);
        CHECK(found.lost == 0);
    });
}

TEST_CASE_TEMPLATE("the bound has a margin of four, and none of sixteen", T, float, double) {
    const auto share_of_bound = [](T share) {
        return [=](SurfacePoint<T> p, const Vector3<T>& direction) {
            p.error *= share;
            return Launch<T>{leave(p, direction)};
        };
    };
    int too_little = 0;
    for_each_kind<T>([&](const std::string& kind, const auto& make) {
        CAPTURE(kind);
        CHECK(mistakes<T>(make, share_of_bound(T(0.25)), 20'000).self_hits == 0);
        too_little += mistakes<T>(make, share_of_bound(T(1) / 16), 20'000).self_hits;
    });
    CHECK(too_little > 0);
}

TEST_CASE("no epsilon can do that: a small one finds the own surface, a large one loses another") {
    for_each_kind<float>([](const std::string& kind, const auto& make) {
        CAPTURE(kind);
        const Mistakes none = mistakes<float>(make, by_epsilon(0.0F), 2000);
        CHECK(none.self_hits >= none.rays / 10);
        const Mistakes small = mistakes<float>(make, by_epsilon(1e-4F), 2000);
        CHECK(small.self_hits >= small.rays / 50);
        CHECK(small.lost >= small.rays / 50);
        const Mistakes huge = mistakes<float>(make, by_epsilon(1e3F), 2000);
        CHECK(huge.lost >= huge.rays / 3);
    });
}

TEST_CASE_TEMPLATE("between two surfaces, neither is met, and what stands close before one is", T, float,
                   double) {
    int blocked = 0, missed = 0, asked = 0;
    for (int decade = -4; decade <= 4; ++decade) {
        const double scale = std::pow(10.0, decade);
        for (int i = 0; i < 20'000; ++i) {
            Rng        rng{9, decade, i, 0};
            const auto one = some_triangle<T>(scale, rng), two = some_triangle<T>(scale, rng);
            const auto eye = Vector3<T>(10 * scale * normalize(in_unit_ball<double>(rng)));
            const auto a   = point_hit(one.shape, Ray<T>{eye, Vector3<T>(one.aim) - eye});
            const auto b   = point_hit(two.shape, Ray<T>{eye, Vector3<T>(two.aim) - eye});
            if (!a || !b) continue;
            const Vector3<T> apart = b->position - a->position;
            const T          reach = length(apart);
            // Within 10^-3 of a surface's plane it depends on roundings on which side the other point is.
            if (std::abs(dot(apart, a->normal)) < T(1e-3) * reach) continue;
            if (std::abs(dot(apart, b->normal)) < T(1e-3) * reach) continue;
            if (reach < T(0.1 * scale)) continue;
            ++asked;
            const Launch<T> launch{between(*a, *b), before_the_end<T>};
            // The needles' own planes may cross each other: each triangle alone is asked.
            blocked += meets(launch, one.shape) || meets(launch, two.shape) ? 1 : 0;
            missed += meets(launch, Plane<T>{b->position - T(1e-3) * apart, apart}) ? 0 : 1;
            missed += meets(launch, Plane<T>{a->position + T(1e-3) * apart, apart}) ? 0 : 1;
        }
    }
    CHECK(asked >= 100'000);
    CHECK(blocked == 0);
    CHECK(missed == 0);
}

TEST_CASE_TEMPLATE("a surface point is on its surface, within its error", T, float, double) {
    for (int i = 0; i < 20'000; ++i) {
        Rng        rng{10, i, 0, 0};
        const auto sphere = some_sphere<T>(1, rng);
        const auto plane  = some_plane<T>(1, rng);
        const auto eye    = Vector3<T>(10.0 * normalize(in_unit_ball<double>(rng)));
        if (const auto p = point_hit(sphere.shape, Ray<T>{eye, Vector3<T>(sphere.aim) - eye})) {
            const double away = length(Exact(p->position) - Exact(sphere.shape.centre));
            REQUIRE(std::abs(away - double(sphere.shape.radius)) <= double(p->error));
        }
        if (const auto p = point_hit(plane.shape, Ray<T>{eye, Vector3<T>(plane.aim) - eye})) {
            const double away =
                dot(normalize(Exact(plane.shape.normal)), Exact(p->position) - Exact(plane.shape.point));
            REQUIRE(std::abs(away) <= double(p->error));
        }
    }
}

TEST_CASE("at the origin of all coordinates a point still leaves its surface") {
    const Plane<float> floor{{0, 0, 0}, {0, 0, 1}};
    const auto         p = surface_point(floor, Ray<float>{{0, 0, 1}, {0, 0, -1}}, 1.0F);
    CHECK(p.error > 0);
    for (const float z : {1.0F, -1.0F, 1e-3F}) CHECK(!intersect(floor, leave(p, {1, 1, z})));
    CHECK(intersect(Plane<float>{{0, 0, 1e-20F}, {0, 0, 1}}, leave(p, {1, 1, 1})));
}

TEST_CASE_TEMPLATE("no bit pattern makes a ray that leaves a surface hit at what is no number", T, float,
                   double) {
    check_law("a hit after leaving is finite, or none", [] {
        const auto        number = any_bits<T>();
        const Ray<T>      ray{vector_of(number), vector_of(number)};
        const Sphere<T>   sphere{vector_of(number), *number};
        const Plane<T>    plane{vector_of(number), vector_of(number)};
        const Triangle<T> triangle{vector_of(number), vector_of(number), vector_of(number)};
        const auto        direction = vector_of(number);
        const T           t = *number, u = *number, v = *number;
        for (const auto& p : {surface_point(sphere, ray, t), surface_point(plane, ray, t),
                              surface_point(triangle, Vector2<T>{u, v})}) {
            const auto next = leave(p, direction);
            const auto hits = {intersect(sphere, next), intersect(plane, next)};
            for (const auto& hit : hits) RC_ASSERT((!hit || std::isfinite(*hit)));
        }
    });
}
