/// @file warps.cpp
/// The unit square mapped to disks, spheres, triangles and spherical triangles: each draws from the density it states,
/// and is undone by its inverse, also at the ends of the numbers that come.

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

#include "geometry/triangle.hpp"
#include "law.hpp"
#include "math/extremes.hpp"
#include "math/square.hpp"
#include "near.hpp"
#include "radiometry/polygon_solid_angle.hpp"
#include "sampled_density.hpp"
#include "sampling/concentric_disk.hpp"
#include "sampling/hemisphere.hpp"
#include "sampling/power_cosine.hpp"
#include "sampling/sphere.hpp"
#include "sampling/spherical_triangle.hpp"
#include "sampling/triangle_points.hpp"
#include "statistics/running.hpp"
#include "vector_of.hpp"

using namespace sr;
using namespace sr::test;
using std::numbers::pi;

namespace {

/// 0, the largest number below 1, 1/2 where maps may have a seam, and numbers between.
template <class T>
std::vector<Vector2<T>> square_points() {
    std::vector<Vector2<T>> points;
    for (const T x : {T(0), T(0.25), T(0.5), largest_below_1<T>})
        for (const T y : {T(0), T(0.25), T(0.5), largest_below_1<T>}) points.push_back({x, y});
    Rng rng{21, 0, 0, 0};
    for (int i = 0; i < 2000; ++i) points.push_back(square_point<T>(rng));
    return points;
}

/// Of a number that a whole turn brings back.
template <class T>
double turned(T a, T b) {
    const double difference = std::abs(double(a) - double(b));
    return std::min(difference, 1 - difference);
}

/// Whether a mean is what it should be, to 5 standard errors.
bool is_mean(const Running& of, double expected) {
    return std::abs(of.mean() - expected) <= 5 * of.standard_error();
}

/// The mean of a function of points that are drawn.
template <class Draw, class F>
Running mean_of(const Draw& draw, const F& f) {
    Rng     rng{22, 0, 0, 0};
    Running mean;
    for (int i = 0; i < 100'000; ++i) mean.add(f(draw(square_point<double>(rng))));
    return mean;
}

/// A disk's, by r^2 and azimuth.
auto disk_chart(double radius) {
    return DomainMap{
        [=](const Vector2<double>& s) {
            const double r = radius * std::sqrt(s.x), phi = 2 * pi * s.y;
            return Vector2<double>{r * std::cos(phi), r * std::sin(phi)};
        },
        [=](const Vector2<double>& p) {
            return Vector2<double>{dot(p, p) / square(radius), turn(Vector3<double>{p.x, p.y, 0})};
        },
        [=](const Vector2<double>&) { return pi * square(radius); }};
}

/// That of the sphere from z = -1 or 0 to 1, by z and azimuth.
auto height_chart(double lowest) {
    return DomainMap{[=](const Vector2<double>& s) {
                         const double z = lowest + (1 - lowest) * s.x, r = std::sqrt((1 - z) * (1 + z));
                         return Vector3<double>{r * std::cos(2 * pi * s.y), r * std::sin(2 * pi * s.y), z};
                     },
                     [=](const Vector3<double>& w) {
                         return Vector2<double>{(w.z - lowest) / (1 - lowest), turn(w)};
                     },
                     [=](const Vector2<double>&) { return 2 * pi * (1 - lowest); }};
}

/// A triangle's weights, by x and y / (1 - x).
/// @param size  (weights) -> the domain's measure per weights'
template <class Size>
auto weights_chart(const Size& size) {
    const auto at = [](const Vector2<double>& s) { return Vector2<double>{s.x, s.y * (1 - s.x)}; };
    return DomainMap{at,
                     [](const Vector2<double>& w) {
                         return Vector2<double>{w.x, w.x < 1 ? w.y / (1 - w.x) : 0};
                     },
                     [=](const Vector2<double>& s) { return (1 - s.x) * size(at(s)); }};
}

/// As it is seen from the origin: d omega = cos dA / r^2.
auto seen_chart(const Triangle<double>& triangle) {
    const auto normal = area_vector(triangle);
    return weights_chart([=](const Vector2<double>& w) {
        const auto p = (1 - w.x - w.y) * triangle.a + w.x * triangle.b + w.y * triangle.c;
        return std::abs(dot(p, normal)) / (dot(p, p) * length(p));
    });
}

template <class T>
struct Named {
    std::string name;
    Triangle<T> triangle;
};

/// One eighth of all directions, slivers, nearly half of all, a small one, one that is far and one that is near.
template <class T>
std::vector<Named<T>> triangles() {
    const T x = T(-0.5), y = std::sqrt(T(0.75));
    return {{"octant", {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}},
            {"wide", {{10, 0, T(0.1)}, {10 * x, 10 * y, T(0.1)}, {10 * x, -10 * y, T(0.1)}}},
            {"clockwise", {{1, 2, T(0.5)}, {3, T(0.5), 1}, {T(-0.3), 1, 2}}},
            {"sliver", {{-5, 0, 1}, {5, T(0.1), 1}, {0, T(0.2), 1}}},
            {"grazing", {{1, 0, T(0.01)}, {0, 1, T(0.01)}, {3, 3, T(0.01)}}},
            {"small", {{0, 0, 1}, {T(1e-6), 0, 1}, {0, T(1e-6), 1}}},
            {"far", {{0, 0, T(1e6)}, {1, T(0.2), T(1e6)}, {0, 2, T(1e6)}}},
            {"near", {{-1, -1, T(1e-3)}, {1, -1, T(1e-3)}, {0, 1, T(1e-3)}}}};
}

template <class T>
SphericalTriangle<T> seen(const Triangle<T>& triangle) {
    return {triangle.a, triangle.b, triangle.c};
}

}  // namespace

TEST_CASE_TEMPLATE("concentric disk: sample and invert undo each other, and the rim belongs to the disk", T,
                   float, double) {
    const double epsilon = double(std::numeric_limits<T>::epsilon());
    for (const T radius : {T(1), T(0.3), T(1000)}) {
        for (const auto& u : square_points<T>()) {
            const auto p    = sample_concentric_disk(u, radius);
            const auto back = invert_concentric_disk(p, radius);
            REQUIRE(pdf_disk(p, radius).value == near(1 / (pi * square(double(radius))), 1e-12));
            REQUIRE(std::abs(double(back.x - u.x)) <= 4 * epsilon);
            REQUIRE(std::abs(double(back.y - u.y)) <= 4 * epsilon);
        }
        for (int i = 0; i < 4096; ++i) {
            const auto edge = sample_concentric_disk(Vector2<T>{0, T(i) / 4096}, radius);
            REQUIRE(double(length(edge) / radius) == near(1, 4 * epsilon));
            REQUIRE(pdf_disk(edge, radius).value > 0);
            const auto polar = sample_disk(Vector2<T>{largest_below_1<T>, T(i) / 4096}, radius);
            REQUIRE(pdf_disk(polar, radius).value > 0);
        }
    }
    CHECK(pdf_disk(Vector2<T>{T(1.00001), 0}, T(1)).value == 0);
    CHECK(sample_concentric_disk(Vector2<T>{T(0.5), T(0.5)}, T(1)) == Vector2<T>{0, 0});
    CHECK(invert_concentric_disk(Vector2<T>{0, 0}, T(1)) == Vector2<T>{T(0.5), T(0.5)});
}

TEST_CASE("concentric disk: uniform, H1's moments, and no seam; the radius u is refused") {
    const auto map  = [](const Vector2<double>& u) { return sample_concentric_disk(u, 2.0); };
    const auto draw = [&](Rng& rng) { return map(square_point<double>(rng)); };
    const auto pdf  = [](const Vector2<double>& p) { return pdf_disk(p, 2.0).value; };
    CHECK(integral(disk_chart(2), pdf) == near(1, 1e-12));
    CHECK(chance_of_density(disk_chart(2), draw, pdf) > significance);
    const auto wrong = [](Rng& rng) {
        const auto u = square_point<double>(rng);
        return sample_disk(Vector2<double>{square(u.x), u.y}, 2.0);
    };
    CHECK(chance_of_density(disk_chart(2), wrong, pdf) < refused);
    // H1: E[r] = 2/3 and E[r^2] = 1/2 of the unit disk
    CHECK(is_mean(mean_of(map, [](const auto& p) { return length(p) / 2; }), 2.0 / 3));
    CHECK(is_mean(mean_of(map, [](const auto& p) { return dot(p, p) / 4; }), 0.5));
    CHECK(!is_mean(mean_of([](const auto& u) { return u.x; }, [](double r) { return r * r; }), 0.5));
    // Neighbours stay neighbours, along the diagonals where the two halves of the map meet, too. Its derivative by
    // (a, b) is R times the matrix (1, 0; -k t, k), k = pi / 4, whose norm is largest, 1.3824, on the diagonals, t = 1;
    // and a = 2 u.x - 1. The polar map, across the line where it is cut, is stretched by more.
    const auto stretch = [](const auto& of) {
        Rng    rng{23, 0, 0, 0};
        double most = 0;
        for (int i = 0; i < 20'000; ++i) {
            const auto along = square_point<double>(rng), offset = square_point<double>(rng);
            const auto u      = i % 2 == 0 ? along : Vector2<double>{along.x, 1 - along.x};
            const auto beside = u + 1e-6 * (offset - Vector2<double>{0.5, 0.5});
            most              = max_or_nan(most, length(of(u) - of(beside)) / length(u - beside));
        }
        return most;
    };
    CHECK(stretch(map) <= 2 * 2 * 1.3825);
    CHECK(stretch([](const Vector2<double>& u) { return sample_disk(u, 2.0); }) > 2 * pi * 1.9);
}

TEST_CASE_TEMPLATE("sphere: sample and invert undo each other, to the poles", T, float, double) {
    const double epsilon = double(std::numeric_limits<T>::epsilon());
    for (const auto& u : square_points<T>()) {
        const auto w    = sample_uniform_sphere(u);
        const auto back = invert_uniform_sphere(w);
        REQUIRE(double(length(w)) == near(1, 4 * epsilon));
        REQUIRE(std::abs(double(back.x - u.x)) <= epsilon);
        if (u.x > 0) REQUIRE(turned(back.y, u.y) <= 2 * epsilon);
    }
    CHECK(sample_uniform_sphere(Vector2<T>{0, 0}) == Vector3<T>{0, 0, 1});
    // 1 - z^2 has rounded to 0 here, or to twice what it is
    const T tiny = square(std::numeric_limits<T>::epsilon());
    CHECK(double(sample_uniform_sphere(Vector2<T>{tiny, 0}).x) ==
          near(2 * std::numeric_limits<T>::epsilon(), 1e-6));
}

TEST_CASE("sphere: uniform, and H1's moments; a z that is uniform in the angle is refused") {
    const auto map  = [](const Vector2<double>& u) { return sample_uniform_sphere(u); };
    const auto draw = [&](Rng& rng) { return map(square_point<double>(rng)); };
    const auto pdf  = [](const Vector3<double>& w) { return pdf_uniform_sphere(w).value; };
    CHECK(integral(height_chart(-1), pdf) == near(1, 1e-12));
    CHECK(chance_of_density(height_chart(-1), draw, pdf) > significance);
    const auto wrong = [](Rng& rng) {
        const auto   u     = square_point<double>(rng);
        const double theta = pi * u.x, phi = 2 * pi * u.y;
        return Vector3<double>{std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi),
                               std::cos(theta)};
    };
    CHECK(chance_of_density(height_chart(-1), wrong, pdf) < refused);
    // E[z] = 0 and, by symmetry, E[x^2] = E[y^2] = E[z^2] = 1/3
    CHECK(is_mean(mean_of(map, [](const auto& w) { return w.z; }), 0));
    CHECK(is_mean(mean_of(map, [](const auto& w) { return w.x * w.x; }), 1.0 / 3));
    CHECK(is_mean(mean_of(map, [](const auto& w) { return w.z * w.z; }), 1.0 / 3));
    CHECK(is_mean(mean_of(map, [](const auto& w) { return w.x * w.y; }), 0));
}

TEST_CASE("H1: the hemispheres' moments, and draws that follow their densities and not each other's") {
    const auto uniform = [](const Vector2<double>& u) { return sample_uniform_hemisphere(u); };
    const auto cosine  = [](const Vector2<double>& u) { return sample_cosine_hemisphere(u); };
    const auto power   = [](const Vector2<double>& u) { return sample_power_cosine(u, 10.0); };
    const auto z       = [](const Vector3<double>& w) { return w.z; };
    const auto z2      = [](const Vector3<double>& w) { return w.z * w.z; };
    CHECK(is_mean(mean_of(uniform, z), 0.5));
    CHECK(is_mean(mean_of(uniform, z2), 0.33333333333333333));
    CHECK(is_mean(mean_of(cosine, z), 0.66666666666666667));
    CHECK(is_mean(mean_of(cosine, z2), 0.5));
    CHECK(is_mean(mean_of(uniform, [](const auto& w) { return square(w.z - 0.5); }), 0.083333333333333333));
    CHECK(
        is_mean(mean_of(cosine, [](const auto& w) { return square(w.z - 2.0 / 3); }), 0.055555555555555556));
    CHECK(is_mean(mean_of(power, z), 11.0 / 12));
    CHECK(!is_mean(mean_of(uniform, z), 0.51));
    CHECK(!is_mean(mean_of(cosine, z), 0.66));

    const auto of_uniform = [](const Vector3<double>& w) { return pdf_uniform_hemisphere(w).value; };
    const auto of_cosine  = [](const Vector3<double>& w) { return pdf_cosine_hemisphere(w).value; };
    const auto of_power   = [](const Vector3<double>& w) { return pdf_power_cosine(w, 10.0).value; };
    const auto chance     = [](const auto& map, const auto& pdf) {
        CHECK(integral(height_chart(0), pdf) == near(1, 1e-10));
        return chance_of_density(
                height_chart(0), [&](Rng& rng) { return map(square_point<double>(rng)); }, pdf);
    };
    CHECK(chance(uniform, of_uniform) > significance);
    CHECK(chance(cosine, of_cosine) > significance);
    CHECK(chance(power, of_power) > significance);
    CHECK(chance(uniform, of_cosine) < refused);
    CHECK(chance(cosine, of_uniform) < refused);
    CHECK(chance(power, [](const auto& w) { return pdf_power_cosine(w, 10.5).value; }) < refused);
}

TEST_CASE_TEMPLATE("triangle: sample and invert undo each other, and no weight is negative", T, float,
                   double) {
    const double epsilon = double(std::numeric_limits<T>::epsilon());
    for (const auto& u : square_points<T>()) {
        const auto w    = sample_triangle(u);
        const auto back = invert_triangle(w);
        REQUIRE(w.x >= 0);
        REQUIRE(w.y >= 0);
        REQUIRE(1 - w.x - w.y >= 0);
        REQUIRE(pdf_triangle(w, T(0.5)).value == 2);
        REQUIRE(std::abs(double(back.x - u.x)) <= epsilon);
        // near the corner the weights have rounded by epsilon / 4, and what is left is sqrt(u.x)
        if (u.x > 0) REQUIRE(std::abs(double(back.y - u.y)) <= epsilon / double(std::sqrt(u.x)));
    }
    // next to the corner, where the weights have rounded most, and on the far side
    for (int i = 0; i < 4096; ++i) {
        const auto w =
            sample_triangle(Vector2<T>{T(i) * std::numeric_limits<T>::epsilon() / 2, largest_below_1<T>});
        REQUIRE(1 - (w.x + w.y) >= 0);
        REQUIRE((1 - w.x) - w.y >= 0);
    }
    CHECK(sample_triangle(Vector2<T>{0, T(0.7)}) == Vector2<T>{1, 0});
    CHECK(invert_triangle(Vector2<T>{1, 0}) == Vector2<T>{0, 0});
    for (const Vector2<T>& outside : {Vector2<T>{T(-0.01), T(0.5)}, {T(0.5), T(-0.01)}, {T(0.5), T(0.51)}})
        CHECK(pdf_triangle(outside, T(1)).value == 0);
}

TEST_CASE("H23: a triangle's points have its moments and are uniform; without the square root they are not") {
    const auto   map   = [](const Vector2<double>& u) { return sample_triangle(u); };
    const auto   wrong = [](const Vector2<double>& u) { return Vector2<double>{u.x, u.y * (1 - u.x)}; };
    const auto   x     = [](const Vector2<double>& p) { return p.x; };
    const auto   y     = [](const Vector2<double>& p) { return p.y; };
    const double third = 0.33333333333333333;
    CHECK(is_mean(mean_of(map, x), third));
    CHECK(is_mean(mean_of(map, y), third));
    CHECK(is_mean(mean_of(map, [&](const auto& p) { return square(p.x - third); }), 0.055555555555555556));
    CHECK(is_mean(mean_of(map, [&](const auto& p) { return square(p.y - third); }), 0.055555555555555556));
    CHECK(is_mean(mean_of(map, [&](const auto& p) { return (p.x - third) * (p.y - third); }),
                  -0.027777777777777778));
    CHECK(is_mean(mean_of(wrong, x), 0.5));
    CHECK(is_mean(mean_of(wrong, y), 0.25));
    CHECK(!is_mean(mean_of(wrong, y), third));

    const double area  = 0.7;
    const auto   chart = weights_chart([=](const Vector2<double>&) { return 2 * area; });
    const auto   pdf   = [=](const Vector2<double>& w) { return pdf_triangle(w, area).value; };
    CHECK(integral(chart, pdf) == near(1, 1e-12));
    CHECK(chance_of_density(
              chart, [&](Rng& rng) { return map(square_point<double>(rng)); }, pdf) > significance);
    CHECK(chance_of_density(
              chart, [&](Rng& rng) { return wrong(square_point<double>(rng)); }, pdf) < refused);
}

TEST_CASE_TEMPLATE("spherical triangle: sample and invert undo each other, however small it is seen", T,
                   float, double) {
    const double epsilon = double(std::numeric_limits<T>::epsilon());
    for (const auto& [name, triangle] : triangles<T>()) {
        CAPTURE(name);
        const auto of         = seen(triangle);
        const auto& [a, b, c] = triangle;
        const double exact =
            solid_angle(Triangle<double>{Vector3<double>(a), Vector3<double>(b), Vector3<double>(c)}).value();
        CHECK(double(of.solid_angle()) == near(exact, 16 * epsilon));
        // a weight is rounded by epsilon / 4, and its point by that share of a side; from the origin, a height above
        // the plane, that is an angle
        const double height = double(std::abs(dot(a, normalize(area_vector(triangle)))));
        const double side   = double(std::max({length(b - a), length(c - b), length(a - c)}));
        const double error  = 2 * epsilon * (8 + side / height);
        for (const auto& u : square_points<T>()) {
            const auto w    = of.sample(u);
            const auto back = of.invert(w);
            REQUIRE(1 - w.x - w.y >= 0);
            REQUIRE(of.pdf(w).value == near(1 / double(of.solid_angle()), 1e-15));
            REQUIRE(std::abs(double(back.x - u.x)) <= error);
            if (u.x > 0) REQUIRE(std::abs(double(back.y - u.y)) <= error / double(std::sqrt(u.x)));
        }
        CHECK(of.invert({1, 0}) == Vector2<T>{0, 0});
        for (const Vector2<T>& outside :
             {Vector2<T>{T(-0.01), T(0.5)}, {T(0.5), T(-0.01)}, {T(0.5), T(0.51)}})
            CHECK(of.pdf(outside).value == 0);
    }
    CHECK(double(seen(triangles<T>()[0].triangle).solid_angle()) == near(pi / 2, 2 * epsilon));
}

TEST_CASE(
    "spherical triangle: directions follow 1 / solid angle; points of equal areas don't, unless it is "
    "small") {
    for (const auto& [name, triangle] : triangles<double>()) {
        CAPTURE(name);
        const auto of    = seen(triangle);
        const auto chart = seen_chart(triangle);
        if (of.solid_angle() > 5)
            continue;  // so near that d omega / dA is crowded in a few cells; the next case is for it
        const auto pdf   = [&](const Vector2<double>& w) { return of.pdf(w).value; };
        const bool small = of.solid_angle() < 1e-6;
        CHECK(integral(chart, pdf) == near(1, 1e-6));
        const auto draw    = [&](Rng& rng) { return of.sample(square_point<double>(rng)); };
        const auto by_area = [](Rng& rng) { return sample_triangle(square_point<double>(rng)); };
        CHECK(chance_of_density(chart, draw, pdf) > significance);
        const double p_by_area = chance_of_density(chart, by_area, pdf);
        CHECK((small ? p_by_area > significance : p_by_area < refused));
    }
}

TEST_CASE(
    "spherical triangle: u.y is the share of the solid angle, by another formula, and u.x that of 1 - cos") {
    for (const auto& [name, triangle] : triangles<double>()) {
        CAPTURE(name);
        const auto of         = seen(triangle);
        const auto& [a, b, c] = triangle;
        const auto height     = [&](const Vector3<double>& p) {  // 1 - cos of the angle from b
            const double sine   = length(cross(b, p - b)) / (length(b) * length(p));
            const double cosine = dot(b, p) / (length(b) * length(p));
            return cosine > 0 ? square(sine) / (1 + cosine) : 1 - cosine;
        };
        Rng rng{24, 0, 0, 0};
        for (int i = 0; i < 1000; ++i) {
            const auto   u   = square_point<double>(rng);
            const auto   w   = of.sample(u);
            const double end = w.y / (1 - w.x);
            const auto   at  = a + end * (c - a);
            const auto   p   = (1 - w.x) * (end * (c - a) + (a - b)) + b;
            REQUIRE(solid_angle(Triangle<double>{a, b, at}).value() / of.solid_angle() == near(u.y, 1e-8));
            REQUIRE(height(p) / height(at) == near(u.x, 1e-8));
        }
    }
}

TEST_CASE_TEMPLATE("spherical triangle: seen smaller and smaller, its points become those of the area", T,
                   float, double) {
    for (const T side : {T(1e-2), T(1e-4), T(1e-8), T(1e-16)}) {
        const SphericalTriangle<T> of({0, 0, 1}, {side, 0, 1}, {0, side, 1});
        Rng                        rng{25, 0, 0, 0};
        for (int i = 0; i < 1000; ++i) {
            const auto u    = square_point<T>(rng);
            const auto seen = of.sample(u), flat = sample_triangle(u);
            const auto apart = double(length(seen - flat));
            REQUIRE(apart <= double(square(side)) + 16 * double(std::numeric_limits<T>::epsilon()));
        }
        // The solid angle is the area times the mean of (1 + r^2)^(-3/2) = 1 - 3/2 r^2 + 15/8 r^4 ..., and r^2 is
        // side^2 / 3 on average.
        const double s2 = square(double(side));
        CHECK(of.pdf({T(0.3), T(0.3)}).value ==
              near(pdf_triangle(Vector2<T>{T(0.3), T(0.3)}, side * side / 2).value * (1 + s2 / 2),
                   square(s2) + 4 * double(std::numeric_limits<T>::epsilon())));
    }
}

TEST_CASE_TEMPLATE(
    "spherical triangle: of any corners out of whose plane the origin lies, points are of the triangle", T,
    float, double) {
    check_law("weights are not negative, and their sum is at most 1", [] {
        const auto a = vector_of(finite<T>()), b = vector_of(finite<T>()), c = vector_of(finite<T>());
        const SphericalTriangle<T> of(a, b, c);
        const T                    height = std::abs(dot(a, normalize(area_vector(Triangle<T>{a, b, c}))));
        RC_PRE(height > T(1e-3) * std::max({length(a), length(b), length(c)}));
        for (const T x : {T(0), T(0.3), largest_below_1<T>}) {
            for (const T y : {T(0), T(0.3), largest_below_1<T>}) {
                const auto w = of.sample({x, y});
                RC_ASSERT(w.x >= 0);
                RC_ASSERT(w.y >= 0);
                RC_ASSERT(w.x + w.y <= 1);
                RC_ASSERT(of.pdf(w).value > 0);
            }
        }
    });
}
