/// @file solid_angles.cpp
/// How large does a thing look? The share of random rays that hit it, against closed forms: an intersector that
/// is a little too large or too small anywhere is found out, whatever the place.

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <tuple>

#include "geometry/box.hpp"
#include "geometry/plane.hpp"
#include "geometry/sphere.hpp"
#include "geometry/triangle.hpp"
#include "math/frame.hpp"
#include "sampling/cone.hpp"
#include "sampling/rng.hpp"
#include "statistics/tests.hpp"

using namespace sr;

namespace {

/// The directions within an angle of an axis. The angle's sine s is at most 1: a hemisphere.
struct Cone {
    Vector3<double> axis;
    double          s = 1;

    [[nodiscard]] double solid_angle() const { return 2 * std::numbers::pi * cone_height(s); }

    /// Uniformly distributed.
    [[nodiscard]] Vector3<double> direction(Rng& rng) const {
        const double u = rng.uniform<double>();
        return frame_around(normalize(axis)).to_world(sample_cone({u, rng.uniform<double>()}, s));
    }
};

/// How many standard errors the solid angle that the hits count lies from `expected`.
template <class T, class Hits>
double deviation(const Vector3<double>& viewer, const Cone& cone, double expected, const Hits& hits) {
    constexpr int rays = 400'000;
    Rng           rng{6, 0, 0, 0};
    int           count = 0;
    for (int i = 0; i < rays; ++i) count += hits(Ray<T>{viewer, cone.direction(rng)}) ? 1 : 0;
    const double p = double(count) / rays, whole = cone.solid_angle();
    return z_test(p * whole, whole * std::sqrt(p * (1 - p) / rays), expected).z;
}

/// Within five standard errors; and a solid angle that is off by 5 % is not.
template <class T, class Hits>
void check_solid_angle(const Vector3<double>& viewer, const Cone& cone, double expected, const Hits& hits) {
    CAPTURE(expected);
    const double z = deviation<T>(viewer, cone, expected, hits);
    CHECK(std::abs(z) <= 5);
    CHECK(std::abs(deviation<T>(viewer, cone, 1.05 * expected, hits)) > 5);
}

}  // namespace

TEST_CASE_TEMPLATE("A1 a sphere seen from outside", T, float, double) {
    const Sphere<T> sphere{{0, 0, 0}, 1};
    for (const auto& [d, expected] : {std::pair{1.5, 1.5999754864857689},
                                      {2.0, 0.84178721447693293},
                                      {10.0, 0.031494861522999096},
                                      {1e3, 3.1415934389883493e-6},
                                      {1e8, 3.1415926535897933e-16}}) {
        if (sizeof(T) == 4 && d > 1e4) continue;  // the radius is less than a float's step there
        check_solid_angle<T>({0, 0, d}, {{0, 0, -1}, std::min(1.0, 1.4 / d)}, expected,
                             [&](const Ray<T>& ray) { return intersect(sphere, ray).has_value(); });
    }
}

TEST_CASE_TEMPLATE("A2 a disk on its axis", T, float, double) {
    const Plane<T> plane{.point = {0, 0, 0}, .normal = {0, 0, 1}};
    for (const auto& [radius, h, expected] : {std::tuple{1.0, 1.0, 1.8403023690212202},
                                              {1.0, 2.0, 0.66333352234700536},
                                              {3.0, 1.0, 4.2962676540203662}}) {
        check_solid_angle<T>({0, 0, h}, {{0, 0, -1}}, expected, [&](const Ray<T>& ray) {
            const auto t = intersect(plane, ray);
            return t && length(ray.at(*t)) <= T(radius);
        });
    }
}

TEST_CASE_TEMPLATE("A3, A4 a rectangle, which is a box without thickness", T, float, double) {
    const auto sees = [](const Box<T>& flat) {
        return [&](const Ray<T>& ray) { return !BoxRay<T>(ray).clip(flat, in_front<T>).empty(); };
    };
    for (const auto& [a, b, expected] : {std::tuple{1.0, 1.0, 2.0943951023931955},
                                         {0.5, 0.5, 0.80543168316132317},
                                         {2.0, 0.25, 0.87467578349576785}}) {
        const Box<T> flat{{-T(a), -T(b), 0}, {T(a), T(b), 0}};
        check_solid_angle<T>({0, 0, 1}, {{0, 0, -1}}, expected, sees(flat));
    }
    const Box<T> aside{{1, T(0.5), 0}, {3, 2, 0}};
    check_solid_angle<T>({0, 0, 1}, {{2, 1, -1}, 0.7}, 0.21207982090554895, sees(aside));
}

TEST_CASE_TEMPLATE("A5, A6 a triangle", T, float, double) {
    for (const auto& [triangle, expected] :
         {std::pair{Triangle<T>{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, 1.5707963267948966},
          {Triangle<T>{{1, 2, 3}, {-1, 1, 2}, {T(0.5), -1, 2}}, 0.39535470701348161}}) {
        const auto middle = Vector3<double>(triangle.a + triangle.b + triangle.c);
        check_solid_angle<T>({0, 0, 0}, {middle}, expected, [&, seen = triangle](const Ray<T>& ray) {
            return TriangleRay<T>(ray).intersect(seen, in_front<T>).has_value();
        });
    }
}
