/// @file sphere.cpp
/// A ray meets a sphere where closed forms say, and no input makes a hit that is none.

#include "geometry/sphere.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>

#include "law.hpp"
#include "vector_of.hpp"

using namespace sr;
using namespace sr::test;

namespace {

template <std::floating_point T>
constexpr Sphere<T> unit_sphere{{0, 0, 0}, 1};

/// Within eight units in the last place, times how much faster t changes than the input.
template <std::floating_point T>
bool agrees(T t, double expected, double condition = 1) {
    return std::abs(double(t) - expected) <=
           8 * condition * double(std::numeric_limits<T>::epsilon()) * std::abs(expected);
}

/// Numbers whose squares, and their products, stay far from the ends of the type.
template <std::floating_point T>
rc::Gen<T> moderate() {
    return rc::gen::map(rc::gen::inRange(-(1 << 20), 1 << 20), [](int i) { return T(i) / T(1 << 16); });
}

}  // namespace

TEST_CASE_TEMPLATE("G1 a ray meets the unit sphere at rational t", T, float, double) {
    // |o + t d| = 1, solved by hand: t = -o.d / d^2 -+ sqrt(1 - h^2) / |d| where the line passes at h = 0 or 0.6
    // from the centre, so that the root is 1 or 0.8.
    struct Case {
        Ray<T> ray;
        double first, second;
    };
    for (const auto& [ray, first, second] :
         {Case{{{0, 0, -5}, {0, 0, 1}}, 4.0, 6.0}, Case{{{-3, T(0.6), 0}, {1, 0, 0}}, 2.2, 3.8},
          Case{{{0, 0, 0}, {0, 1, 0}}, -1.0, 1.0}, Case{{{-3, T(0.6), 0}, {2, 0, 0}}, 1.1, 1.9},
          Case{{{-3, 1, 0}, {1, 0, 0}}, 3.0, 3.0}}) {
        CAPTURE(first);
        const auto roots = crossings(unit_sphere<T>, ray);
        REQUIRE(roots);
        CHECK(agrees(roots->first, first));
        CHECK(agrees(roots->second, second));
        const auto nearest = intersect(unit_sphere<T>, ray);
        REQUIRE(nearest);
        CHECK(*nearest == (first > 0 ? roots->first : roots->second));
    }
    CHECK(!intersect(unit_sphere<T>, {{-3, std::nextafter(T(1), T(2)), 0}, {1, 0, 0}}));
}

TEST_CASE("a range leaves out hits before and behind it") {
    const Ray<double> ray{{0, 0, -5}, {0, 0, 1}};  // enters at 4, leaves at 6
    CHECK(intersect(unit_sphere<double>, ray, {4, 6}) == 4);
    CHECK(intersect(unit_sphere<double>, ray, {4.5, 9}) == 6);
    CHECK(!intersect(unit_sphere<double>, ray, {0, 3.9}));
    CHECK(!intersect(unit_sphere<double>, ray, {6.1, 9}));
    CHECK(!intersect(unit_sphere<double>, {{0, 0, 5}, {0, 0, 1}}));
}

TEST_CASE_TEMPLATE("laws of a ray and a sphere", T, float, double) {
    constexpr T eps = std::numeric_limits<T>::epsilon();
    check_law("a hit is on the sphere, within rounding of the distances in play", [] {
        const auto      number = moderate<T>();
        const Ray<T>    ray{vector_of(number), vector_of(number)};
        const Sphere<T> sphere{vector_of(number), std::abs(*number) + T(0.001)};
        const auto      t = intersect(sphere, ray);
        RC_PRE(t.has_value());
        const Vector3<T>      s = ray.origin - sphere.centre;
        // |p|^2 - r^2 is 2 r off for each unit that p is off, and p is off by roundings of |s| and of r.
        const Vector3<double> p = Vector3<double>(s) + double(*t) * Vector3<double>(ray.direction);
        const double          r = double(sphere.radius), reach = double(length(s)) + r;
        RC_ASSERT(std::abs(dot(p, p) - r * r) <= 32 * double(eps) * reach * reach);
    });
    check_law("a ray from inside leaves, once", [] {
        const auto       number = moderate<T>();
        const Sphere<T>  sphere{{0, 0, 0}, std::abs(*number) + T(0.001)};
        const Vector3<T> to = vector_of(number), any = vector_of(number);
        const bool       grazing   = *rc::gen::arbitrary<bool>();
        const Vector3<T> direction = grazing ? cross(to, any) : any;
        RC_PRE(dot(direction, direction) > T(1e-6));
        RC_PRE(dot(to, to) > 0);
        const Vector3<T> origin = sphere.radius / length(to) * to;
        RC_PRE(difference_of_squares(origin, sphere.radius) < 0);
        const auto roots = crossings(sphere, Ray<T>{origin, direction});
        RC_ASSERT(roots.has_value());
        RC_ASSERT(roots->first < 0);
        RC_ASSERT(roots->second > 0);
    });
    check_law("a power of two in all lengths, or in the direction's, changes no digit", [] {
        const auto      number = moderate<T>();
        const Ray<T>    ray{vector_of(number), vector_of(number)};
        const Sphere<T> sphere{vector_of(number), std::abs(*number) + T(0.001)};
        const T         k     = std::ldexp(T(1), *rc::gen::inRange(-6, 7));
        const auto      roots = crossings(sphere, ray);
        const auto      longer =
            crossings(Sphere<T>{k * sphere.centre, k * sphere.radius}, {k * ray.origin, k * ray.direction});
        const auto faster = crossings(sphere, {ray.origin, k * ray.direction});
        RC_ASSERT(longer.has_value() == roots.has_value());
        RC_ASSERT(faster.has_value() == roots.has_value());
        if (!roots) return;
        RC_ASSERT(longer->first == roots->first);
        RC_ASSERT(faster->first == roots->first / k);
        RC_ASSERT(faster->second == roots->second / k);
    });
    check_law("no bit pattern gives a hit that is not finite or not in the range", [] {
        const auto      number = any_bits<T>();
        const Ray<T>    ray{vector_of(number), vector_of(number)};
        const Sphere<T> sphere{vector_of(number), *number};
        const T         from = *number, to = *number;
        for (const auto& range : {in_front<T>, Interval<T>{from, to}}) {
            const auto t = intersect(sphere, ray, range);
            RC_ASSERT((!t || (std::isfinite(*t) && range.contains(*t))));
        }
    });
}
