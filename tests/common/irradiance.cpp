/// @file irradiance.cpp
/// Irradiance from extended lamps in closed form, equation by equation.

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>
#include <stdexcept>
#include <utility>

#include "geometry/disk.hpp"
#include "geometry/sphere.hpp"
#include "math/degrees.hpp"
#include "math/frame.hpp"
#include "math/gauss_legendre.hpp"
#include "math/square.hpp"
#include "near.hpp"
#include "polygons.hpp"
#include "radiometry/projected_solid_angle.hpp"
#include "radiometry/solid_angle.hpp"

using namespace sr;
using test::near;
using test::Points;
using test::rectangle;

namespace {

using std::numbers::pi;

/// E / (pi L), which tables of heat transfer call the configuration factor.
template <class Shape>
double factor(const Shape& shape) {
    return projected_solid_angle(shape).value() / pi;
}

/// A unit sphere's centre at the distance d in the direction `beta` [rad] from the normal.
Sphere<double> sphere_at(double d, double beta) {
    return {{d * std::sin(beta), 0, d * std::cos(beta)}, 1};
}

/// The integral of max(cos, 0) over a cone of the half-angle with sine s about the direction `beta`. The azimuth is
/// integrated in closed form: of the ring at the angle a, the part above the horizon.
double cone_by_quadrature(double s, double beta) {
    double     sum  = 0;
    const auto ring = [&](double from, double to) {
        for (const auto& [x, weight] : gauss_legendre(200, 0, pi)) {
            const double a = from + (to - from) * (1 - std::cos(x)) / 2;
            // cos(theta) = p + q cos(phi): positive for |phi| < phi0
            const double p = std::cos(beta) * std::cos(a), q = std::sin(beta) * std::sin(a);
            const double phi0 = p >= q ? pi : p <= -q ? 0 : std::acos(-p / q);
            sum += weight * (to - from) * std::sin(x) / 2 * std::sin(a) * 2 * (p * phi0 + q * std::sin(phi0));
        }
    };
    const double rim = std::asin(s), border = std::abs(pi / 2 - beta);
    ring(0, border < rim ? border : rim);
    if (border < rim) ring(border, rim);
    return sum;
}

/// The integral of cos cos' / r^2 over a disk.
double disk_by_quadrature(const Disk<double>& disk) {
    const auto frame = frame_around(disk.normal);
    double     sum   = 0;
    for (const auto& [r, weight] : gauss_legendre(60, 0, disk.radius)) {
        for (int i = 0; i < 256; ++i) {
            const double phi = 2 * pi * i / 256;
            const auto   p   = disk.centre + r * std::cos(phi) * frame.s + r * std::sin(phi) * frame.t;
            sum += weight * 2 * pi / 256 * r * p.z * std::abs(dot(disk.normal, p)) / square(dot(p, p));
        }
    }
    return sum;
}

}  // namespace

TEST_CASE("B3: a sphere above the horizon is a point light; B19: seen from afar, E / Omega is its radiance") {
    CHECK(pi * factor(sphere_at(2, 0)) == near(0.78539816339744831, 1e-14));
    CHECK(pi * factor(sphere_at(2, radians(45))) == near(0.55536036726979578, 1e-14));
    for (const auto& [d, expected] :
         {std::pair{5.0, 0.98989794855663562}, {50.0, 0.9998999899979995}, {500.0, 0.999998999999}}) {
        const auto sphere = sphere_at(d, 0);
        CHECK(projected_solid_angle(sphere) / solid_angle(sphere) == near(expected, 1e-12));
    }
}

TEST_CASE("a sphere that sets: cut by the horizon, against quadrature") {
    for (const double d : {1.05, 1.5, 3.0, 50.0}) {
        const double s = 1 / d;
        for (int i = -9; i <= 9; ++i) {  // across both borders of the case
            const double beta = pi / 2 + 0.11 * i * std::asin(s);
            CAPTURE(d);
            CAPTURE(beta);
            const double expected = cone_by_quadrature(s, beta);
            CHECK(std::abs(pi * factor(sphere_at(d, beta)) - expected) <= 1e-10 * expected + 5e-17);
        }
        CHECK(factor(sphere_at(d, pi / 2 + 1.001 * std::asin(s))) == 0);
        // the two formulas meet where the sphere touches the horizon
        const double touching = pi / 2 - std::asin(s);
        CHECK(factor(sphere_at(d, touching + 1e-9)) == near(factor(sphere_at(d, touching - 1e-9)), 1e-7));
    }
    // half set, s -> 1: half of the hemisphere; and from inside all of it
    CHECK(factor(sphere_at(1 + 1e-12, pi / 2)) == near(0.5, 1e-5));
    CHECK(factor(sphere_at(0.5, 2)) == 1);
    CHECK(std::isnan(factor(sphere_at(std::nan(""), 1))));
}

TEST_CASE("B5, B6: a disk parallel to the receiver, on and off its axis; B17: less one that hides a part") {
    const auto parallel = [](double R, double h, double a) {
        return factor(Disk<double>{{a, 0, h}, {0, 0, -1}, R});
    };
    CHECK(pi * parallel(1, 1, 0) == near(1.5707963267948966, 1e-15));
    CHECK(pi * parallel(1, 3, 0) == near(0.31415926535897932, 1e-15));
    CHECK(parallel(1, 1, 0.5) == near(0.43798263270539577, 1e-14));
    CHECK(parallel(1, 1, 1) == near(0.27639320225002103, 1e-14));
    CHECK(parallel(1, 1, 2) == near(0.052786404500042061, 1e-14));
    CHECK(parallel(1, 2, 0) - parallel(0.25, 1, 0) == near(0.14117647058823529, 1e-14));
    // from afar it is cos cos' A / r^2, in float too
    CHECK(projected_solid_angle(Disk<float>{{0, 0, 1e5F}, {0, 0, 1}, 1}).value() == near(pi * 1e-10, 1e-6));
}

TEST_CASE("a disk that is turned and aside, against quadrature; one that the horizon cuts is refused") {
    for (const auto& normal : {Vector3<double>{1, 2, -3}, {0, 1, 0}, {-2, 1, 1}, {0, 0, 1}}) {
        const Disk<double> disk{{0.7, -0.4, 1.5}, normalize(normal), 0.8};
        CHECK(projected_solid_angle(disk).value() == near(disk_by_quadrature(disk), 1e-10));
        const Disk<double> turned{disk.centre, -disk.normal, disk.radius};
        CHECK(projected_solid_angle(turned).value() == near(projected_solid_angle(disk).value(), 1e-14));
    }
    CHECK_THROWS_WITH_AS((void)projected_solid_angle(Disk<double>{{0, 3, 0.5}, {0, 1, 0}, 1}),
                         "disk: its lowest point is at z = -0.5; must be above the receiver's horizon, z = 0",
                         std::invalid_argument);
    CHECK_THROWS_AS((void)projected_solid_angle(Disk<double>{{0, 3, std::nan("")}, {0, 1, 0}, 1}),
                    std::invalid_argument);
}

TEST_CASE("B8, B9: rectangles above and upright, which a receiver on their corner's plane sees") {
    const auto above = [](double a, double b, double c) { return factor(rectangle(0, a, 0, b, c)); };
    CHECK(above(1, 1, 1) == near(0.138531605994893, 1e-14));
    CHECK(above(2, 1, 0.5) == near(0.22077762233476159, 1e-14));
    CHECK(above(10, 10, 1) == near(0.24797140829531015, 1e-14));
    CHECK(factor(rectangle(-0.5, 0.5, -0.5, 0.5, 1)) == near(0.2394564704607735, 1e-14));

    const auto upright = [](double a, double b, double c, double bottom) {
        return factor(Points{{c, 0, bottom}, {c, b, bottom}, {c, b, a}, {c, 0, a}});
    };
    CHECK(upright(1, 1, 1, 0) == near(0.055734197002553502, 1e-13));
    CHECK(upright(2, 1, 0.5, 0) == near(0.15877480451429929, 1e-13));
    // what hangs below the horizon adds nothing, and what is below it all is dark
    CHECK(upright(2, 1, 0.5, -3) == near(upright(2, 1, 0.5, 0), 1e-14));
    CHECK(upright(-1, 1, 0.5, -3) == 0);
}

TEST_CASE("B10: a triangle, either way round, and with a part below the horizon") {
    const Points triangle{{1, 0, 1}, {0, 2, 1.5}, {-1, -0.5, 2}};
    CHECK(factor(triangle) == near(0.21706592379305565, 1e-14));
    CHECK(factor(Points{triangle[2], triangle[1], triangle[0]}) == near(0.21706592379305565, 1e-14));
    // the cut by hand: (0, 1, 2), (0, 1, -2) and (2, 1, 0) have their part with z >= 0 in the first and the third and
    // in (0, 1, 0)
    CHECK(factor(Points{{0, 1, 2}, {0, 1, -2}, {2, 1, 0}}) ==
          near(factor(Points{{0, 1, 2}, {0, 1, 0}, {2, 1, 0}}), 1e-14));
    // and an edge is cut where it meets the horizon, here after a third
    CHECK(factor(Points{{0, 1, 1}, {3, 1, -2}, {-6, 1, -2}}) ==
          near(factor(Points{{0, 1, 1}, {1, 1, 0}, {-2, 1, 0}}), 1e-14));
    CHECK(std::isnan(factor(Points{{0, 1, 2}, {0, std::nan(""), 0}, {2, 1, 0}})));
}

TEST_CASE("B12, B13: an endless strip, and an endless cylinder, which looks like one") {
    // Seen between two angles from the normal; so long that what is missing is less than the last digit.
    const auto strip = [](double from, double to) {
        constexpr double far = 1e9;
        return factor(Points{{std::tan(from), -far, 1},
                             {std::tan(to), -far, 1},
                             {std::tan(to), far, 1},
                             {std::tan(from), far, 1}});
    };
    CHECK(strip(radians(20), radians(60)) == near(0.26200263022938496, 1e-10));
    CHECK(strip(-std::asin(1.0 / 3), std::asin(1.0 / 3)) == near(0.33333333333333333, 1e-10));
}
