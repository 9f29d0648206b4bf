/// @file solid_angle_formulas.cpp
/// Solid angles in closed form: their values, and where two of them say the same.

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <tuple>

#include "geometry/disk.hpp"
#include "geometry/sphere.hpp"
#include "math/degrees.hpp"
#include "math/elliptic.hpp"
#include "math/frame.hpp"
#include "math/gauss_legendre.hpp"
#include "math/square.hpp"
#include "near.hpp"
#include "polygons.hpp"
#include "radiometry/cap_overlap.hpp"
#include "radiometry/disk_solid_angle.hpp"
#include "radiometry/polygon_solid_angle.hpp"
#include "radiometry/solid_angle.hpp"
#include "sampling/ball.hpp"
#include "sampling/rng.hpp"

using namespace sr;
using test::near;
using test::Points;
using test::rectangle;

namespace {

using std::numbers::pi;

double omega(const Points& polygon) {
    return solid_angle(polygon).value();
}

/// The integral over a cone about z of the angles in a second cone, ring after ring: an overlap by quadrature.
double overlap_by_quadrature(double a, double b, double apart) {
    double     sum  = 0;
    const auto ring = [&](double from, double to) {
        for (const auto& [x, weight] : gauss_legendre(200, 0, pi)) {  // theta bunches at both ends
            const double theta = from + (to - from) * (1 - std::cos(x)) / 2;
            const double c =
                (std::cos(b) - std::cos(theta) * std::cos(apart)) / (std::sin(theta) * std::sin(apart));
            sum += weight * (to - from) * std::sin(x) / 2 * std::sin(theta) * 2 *
                   std::acos(c > 1    ? 1
                             : c < -1 ? -1
                                      : c);
        }
    };
    const double inner = std::abs(apart - b);
    ring(0, inner < a ? inner : a);
    if (inner < a) ring(inner, a < apart + b ? a : apart + b);
    return sum;
}

}  // namespace

TEST_CASE("elliptic integrals: Carlson's published values, and integrals") {
    // Carlson (1995), section 3
    CHECK(carlson_rf(1, 2, 0) == near(1.3110287771461, 5e-14));
    CHECK(carlson_rf(2, 3, 4) == near(0.58408284167715, 1e-14));
    CHECK(carlson_rj(0, 1, 2, 3) == near(0.77688623778582, 1e-14));
    CHECK(carlson_rj(2, 3, 4, 5) == near(0.14297579667157, 5e-14));
    // R_J as an integral over w, t = 1 / w^2 - 1; where its arguments agree, only the series is left
    for (const auto& [x, y, z, p] : {std::array{1.0, 1.0015, 0.9985, 1.0005}, {0.2, 1.0, 3.0, 0.5}}) {
        double sum = 0;
        for (const auto& [w, weight] : gauss_legendre(80, 0, 1)) {
            const auto mixed = [v = w * w](double at) { return 1 - v + at * v; };
            sum += weight * 3 * w * w / (mixed(p) * std::sqrt(mixed(x) * mixed(y) * mixed(z)));
        }
        CHECK(carlson_rj(x, y, z, p) == near(sum, 1e-14));
    }
    for (const auto& [n_complement, complement] :
         {std::pair{0.7, 0.3}, {0.05, 0.6}, {1.5, 0.9}, {0.3, 1.0}}) {
        double k = 0, p = 0;
        for (const auto& [a, weight] : gauss_legendre(60, 0, pi / 2)) {
            const double sine2 = square(std::sin(a)), root = std::sqrt(1 - (1 - complement) * sine2);
            k += weight / root;
            p += weight / ((1 - (1 - n_complement) * sine2) * root);
        }
        CHECK(elliptic_k(complement) == near(k, 1e-13));
        CHECK(elliptic_pi(n_complement, complement) == near(p, 1e-13));
    }
}

TEST_CASE("A1: a sphere's solid angle keeps its digits at any distance; from inside it is 4 pi") {
    for (const auto& [distance, expected] : {std::pair{1.5, 1.5999754864857689},
                                             {2.0, 0.84178721447693293},
                                             {10.0, 0.031494861522999096},
                                             {1e3, 3.1415934389883493e-6},
                                             {1e8, 3.1415926535897933e-16}}) {
        CHECK(solid_angle(Sphere<double>{{0, distance, 0}, 1}).value() == near(expected, 1e-15));
        CHECK(solid_angle(Sphere<float>{{0, 0, float(distance)}, 1}).value() == near(expected, 5e-7));
    }
    // a hair above the surface: the cosine is small, and has its digits
    const double r = 0.7, d = r * (1 + 3e-13), above = d - r;  // the difference is exact
    const double cosine = std::sqrt(above * (2 * r + above)) / d;
    CHECK(2 * pi - solid_angle(Sphere<double>{{0, d, 0}, r}).value() == near(2 * pi * cosine, 1e-6));
    CHECK(solid_angle(Sphere<double>{{0, 0.9, 0}, 1}).value() == 4 * pi);
    CHECK(solid_angle(Sphere<double>{{0, 1, 0}, 1}).value() == 2 * pi);
    CHECK(std::isnan(solid_angle(Sphere<double>{{0, std::nan(""), 0}, 1}).value()));
}

TEST_CASE("A2: a disk on its axis") {
    for (const auto& [R, h, expected] : {std::tuple{1.0, 1.0, 1.8403023690212202},
                                         {1.0, 2.0, 0.66333352234700536},
                                         {3.0, 1.0, 4.2962676540203662}}) {
        CHECK(disk_on_axis_solid_angle(R, h).value() == near(expected, 1e-15));
        CHECK(solid_angle(Disk<double>{{0, 0, -h}, {0, 0, 1}, R}).value() == near(expected, 1e-15));
    }
    CHECK(disk_on_axis_solid_angle(1.0, 0.0).value() == near(2 * pi, 1e-15));
    CHECK(disk_on_axis_solid_angle(1.0F, 1e5F).value() == near(pi * 1e-10, 1e-6));
}

TEST_CASE("A10: a disk off its axis, and on both sides of its rim") {
    const auto seen = [](double h, double a) {
        return solid_angle(Disk<double>{{a, 0, h}, {0, 0, 1}, 1}).value();
    };
    CHECK(seen(1, 0.5) == near(1.6371035493454264, 1e-13));
    CHECK(seen(1, 1) == near(1.12268683361137, 1e-13));
    CHECK(seen(1, 2) == near(0.32580024845345827, 1e-13));
    CHECK(seen(1, 1e-9) == near(seen(1, 0), 1e-13));
    for (const double beside :
         {1e-15, 1e-9, 1e-6}) {  // the formula has three cases, the disk has one solid angle
        CHECK(seen(1, 1 - beside) == near(seen(1, 1), 2 * beside + 1e-13));
        CHECK(seen(1, 1 + beside) == near(seen(1, 1), 2 * beside + 1e-13));
    }
    CHECK(seen(0, 0.5) == 2 * pi);
    CHECK(seen(0, 1.5) == 0);
    // whatever the place, the area of points seen times cos / r^2
    const Disk<double> tilted{{0.4, -0.3, 1.5}, normalize(Vector3<double>{1, 2, -3}), 0.8};
    const auto         frame = frame_around(tilted.normal);
    double             sum   = 0;
    for (const auto& [r, of_r] : gauss_legendre(40, 0, tilted.radius)) {
        for (int i = 0; i < 128; ++i) {
            const double phi = 2 * pi * i / 128;
            const auto   p   = tilted.centre + r * std::cos(phi) * frame.s + r * std::sin(phi) * frame.t;
            sum += of_r * 2 * pi / 128 * r * std::abs(dot(tilted.normal, p)) / std::pow(length(p), 3);
        }
    }
    CHECK(solid_angle(tilted).value() == near(sum, 1e-12));
}

TEST_CASE("A3, A4: rectangles, by their own formula and as polygons") {
    for (const auto& [a, b, h, expected] : {std::tuple{1.0, 1.0, 1.0, 2.0943951023931955},
                                            {0.5, 0.5, 1.0, 0.80543168316132317},
                                            {2.0, 0.25, 1.0, 0.87467578349576785}}) {
        CHECK(centred_rectangle_solid_angle(a, b, h).value() == near(expected, 1e-14));
        CHECK(omega(rectangle(-a, a, -b, b, h)) == near(expected, 1e-14));
    }
    CHECK(centred_rectangle_solid_angle(1.0, 1.0, 0.0).value() == near(2 * pi, 1e-15));
    CHECK(omega(rectangle(1, 3, 0.5, 2, 1)) == near(0.21207982090554895, 1e-14));
}

TEST_CASE("A5, A6, A13: triangles, the last one tiny") {
    const auto seen = [](const Triangle<double>& triangle) { return solid_angle(triangle).value(); };
    CHECK(seen({{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}) == near(1.5707963267948966, 1e-15));
    CHECK(seen({{1, 2, 3}, {-1, 1, 2}, {0.5, -1, 2}}) == near(0.39535470701348161, 1e-14));
    CHECK(seen({{0, 0, 1}, {1e-4, 0, 1}, {0, 1e-4, 1}}) == near(4.9999999750000001e-9, 1e-14));
    const Triangle<double> front{{0, 0, -1}, {1, 0, -1}, {0, 1, -1}};
    CHECK(signed_solid_angle(front).value() > 0);
    CHECK(signed_solid_angle(Triangle<double>{front.a, front.c, front.b}).value() ==
          -signed_solid_angle(front).value());
}

TEST_CASE("A9: a cube, from before a face, from a corner's direction, and from its corner") {
    const auto front = rectangle(-1, 1, -1, 1, -2);  // seen from (0, 0, 3)
    CHECK(omega(front) == near(0.80543168316132317, 1e-14));
    const auto face = rectangle(-4, -2, -4, -2, -2);  // one of three alike, seen from (3, 3, 3)
    CHECK(3 * omega(face) == near(0.24436676278603583, 1e-13));
    const auto far = rectangle(-2, 0, -2, 0, -2);  // one of three, seen from (1, 1, 1)
    CHECK(3 * omega(far) == near(1.5707963267948966, 1e-14));
    // a polygon with a dent is its triangles, some of which count negatively
    const Points dent{{-1, -1, 1}, {1, -1, 1}, {0, 0, 1}, {1, 1, 1}, {-1, 1, 1}};
    CHECK(omega(dent) == near(0.75 * 4 * pi / 6, 1e-14));
    const Points from_the_dent{{1, 1, 1}, {-1, 1, 1}, {-1, -1, 1}, {1, -1, 1}, {0, 0, 1}};
    CHECK(omega(from_the_dent) == near(0.75 * 4 * pi / 6, 1e-14));
}

TEST_CASE("A11, A15: caps that overlap, and one that the horizon cuts") {
    const double light = radians(30), occluder = radians(20);
    const double hidden = cap_overlap(light, occluder, radians(25)).value();
    CHECK(hidden == near(0.22313832362825597, 1e-13));
    const double visible = cap_solid_angle(light).value() - hidden;
    CHECK(visible == near(0.61864889084867695, 1e-13));
    CHECK(visible / cap_solid_angle(light).value() == near(0.73492312571305926, 1e-13));
    CHECK(cap_overlap(light, pi / 2, radians(80)).value() == near(0.59269662270037377, 1e-13));
    CHECK(cap_overlap(light, occluder, radians(50)).value() == 0);
    CHECK(cap_overlap(light, occluder, radians(9)).value() == cap_solid_angle(occluder).value());
    CHECK(std::isnan(cap_overlap(light, occluder, std::nan("")).value()));
    for (const auto& [a, b, apart] :
         {std::tuple{0.5, 0.4, 0.7}, {1.2, 0.3, 1.1}, {1.5, 1.4, 0.5}, {0.3, 1.2, 1.1}})
        CHECK(cap_overlap(a, b, apart).value() == near(overlap_by_quadrature(a, b, apart), 1e-10));
}

TEST_CASE("two triangles with a common edge look as large as their union") {
    Rng rng{1, 0, 0, 0};
    for (int i = 0; i < 1000; ++i) {
        const auto a = in_unit_ball<double>(rng), b = in_unit_ball<double>(rng),
                   c        = in_unit_ball<double>(rng);
        const auto   middle = a + rng.uniform<double>() * (b - a);
        const double whole  = signed_solid_angle(Triangle<double>{a, b, c}).value();
        const double parts  = signed_solid_angle(Triangle<double>{a, middle, c}).value() +
                             signed_solid_angle(Triangle<double>{middle, b, c}).value();
        REQUIRE(std::abs(whole - parts) <= 1e-10);
    }
}

TEST_CASE("d(omega) = cos / r^2 dA: of a small area, nearly its solid angle") {
    const double             side  = 1e-4;
    const Points             small = {{1, 0, 2}, {1 + side, 0, 2}, {1 + side, side, 2}, {1, side, 2}};
    const double             r     = length(small[0] + 0.5 * (small[2] - small[0]));
    const SolidAngle<double> about =
        Area<double>{side * side} * solid_angle_per_area(2 / r, Length<double>{r});
    CHECK(omega(small) == near(about.value(), 1e-8));
}
