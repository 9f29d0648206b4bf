/// @file light_samplers.cpp
/// Cones, disks and spherical rectangles, from which light's directions and points are drawn.

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

#include "math/square.hpp"
#include "near.hpp"
#include "polygons.hpp"
#include "radiometry/polygon_solid_angle.hpp"
#include "sampling/cone.hpp"
#include "sampling/disk.hpp"
#include "sampling/rng.hpp"
#include "sampling/spherical_rectangle.hpp"
#include "statistics/running.hpp"
#include "statistics/tests.hpp"

using namespace sr;
using test::near;

namespace {

constexpr double significance = 1e-3;

/// How uniform points of the unit square are, by 16 x 16 cells.
template <class Draw>
double p_of_uniform(const Draw& draw) {
    constexpr int              cells = 16, draws = 100'000;
    std::vector<std::uint64_t> counts(std::size_t{cells} * cells);
    Rng                        rng{11, 0, 0, 0};
    for (int i = 0; i < draws; ++i) {
        const Vector2<double> u = draw(rng);
        const auto cell = [&](double x) { return std::size_t(std::clamp(int(x * cells), 0, cells - 1)); };
        ++counts[cell(u.x) * std::size_t(cells) + cell(u.y)];
    }
    return chi_square_test(counts, std::vector<double>(counts.size(), double(draws) / double(counts.size())))
        .p;
}

template <class T>
Vector2<T> square_point(Rng& rng) {
    const T x = rng.uniform<T>();
    return {x, rng.uniform<T>()};
}

}  // namespace

TEST_CASE_TEMPLATE("cone: sample and invert undo each other, however narrow it is", T, float, double) {
    Rng rng{1, 0, 0, 0};
    for (const T s : {T(1), T(0.5), T(1e-3), T(1e-6)}) {
        CAPTURE(s);
        for (int i = 0; i < 1000; ++i) {
            const auto u = square_point<T>(rng);
            const auto w = sample_cone(u, s);
            REQUIRE(double(length(w)) == near(1, 4e-7));
            REQUIRE(pdf_cone(w, s).value > 0);
            const auto back = invert_cone(w, s);
            REQUIRE(double(std::abs(back.x - u.x)) <= 2e-6);
            const double turned = std::abs(double(back.y - u.y));
            REQUIRE(std::min(turned, 1 - turned) <= 2e-6);
        }
        CHECK(pdf_cone(Vector3<T>{T(1.01) * s, 0, std::sqrt(std::max(T(0), 1 - square(T(1.01) * s)))}, s)
                  .value == 0);
        CHECK(pdf_cone(Vector3<T>{0, 0, -1}, s).value == 0);
    }
}

TEST_CASE(
    "cone: the density is 1 / solid angle, and a wide cone drawn is uniform; by another sine it is not") {
    CHECK(pdf_cone(Vector3<double>{0, 0, 1}, 1.0).value == near(1 / (2 * std::numbers::pi), 1e-15));
    CHECK(pdf_cone(Vector3<double>{0, 0, 1}, 1e-8).value == near(1 / (std::numbers::pi * 1e-16), 1e-14));
    const auto inverted_with = [](double s) {
        return p_of_uniform(
            [s](Rng& rng) { return invert_cone(sample_cone(square_point<double>(rng), 0.8), s); });
    };
    CHECK(inverted_with(0.8) > significance);
    CHECK(inverted_with(0.82) < 1e-6);
    // H1's moments of the whole hemisphere: E[z] = 1/2, E[z^2] = 1/3
    Running z, z2;
    Rng     rng{3, 0, 0, 0};
    for (int i = 0; i < 100'000; ++i) {
        const double height = sample_cone(square_point<double>(rng), 1.0).z;
        z.add(height);
        z2.add(height * height);
    }
    CHECK(std::abs(z.mean() - 0.5) <= 5 * z.standard_error());
    CHECK(z.variance() == near(0.083333333333333333, 0.02));
    CHECK(std::abs(z2.mean() - 1.0 / 3) <= 5 * z2.standard_error());
}

TEST_CASE("H1: a disk's points: E[r] = 2/3, E[r^2] = 1/2, where r = u would give 1/3") {
    Running r, r2, wrong;
    Rng     rng{4, 0, 0, 0};
    for (int i = 0; i < 100'000; ++i) {
        const auto u = square_point<double>(rng);
        const auto p = sample_disk(u, 1.0);
        r.add(length(p));
        r2.add(dot(p, p));
        wrong.add(square(u.x));
        REQUIRE(pdf_disk(p, 1.0).value == near(1 / std::numbers::pi, 1e-12));
        REQUIRE(invert_disk(p, 1.0).x == near(u.x, 1e-12));
    }
    CHECK(std::abs(r.mean() - 2.0 / 3) <= 5 * r.standard_error());
    CHECK(std::abs(r2.mean() - 0.5) <= 5 * r2.standard_error());
    CHECK(std::abs(wrong.mean() - 0.5) > 50 * wrong.standard_error());
    CHECK(std::abs(wrong.mean() - 1.0 / 3) <= 5 * wrong.standard_error());
    CHECK(pdf_disk(Vector2<double>{2.1, 0}, 2.0).value == 0);
    CHECK(pdf_disk(Vector2<double>{1, 1}, 2.0).value == near(1 / (4 * std::numbers::pi), 1e-12));
    CHECK(p_of_uniform([](Rng& some) {
              return invert_disk(sample_disk(square_point<double>(some), 3.0), 3.0);
          }) > significance);
}

TEST_CASE_TEMPLATE("spherical rectangle: points lie on it, seen uniformly; A4", T, float, double) {
    const SphericalRectangle<T> seen({1, T(0.5)}, {3, 2}, 1);
    CHECK(double(seen.solid_angle()) == near(0.21207982090554895, sizeof(T) == 4 ? 1e-5 : 1e-13));
    CHECK(seen.pdf({1, 1, T(0.5)}).value == near(1 / 0.21207982090554895, 1e-5));  // (2, 2, 1), on the rim
    for (const auto& beside :
         {Vector3<T>{T(0.99), 1, 1}, {T(3.01), 1, 1}, {2, T(0.49), 1}, {2, T(2.01), 1}, {-2, -1, -1}})
        CHECK(seen.pdf(beside).value == 0);
    // u.x is the share of the solid angle at smaller x, by another formula; u.y that of a narrow strip at smaller y
    const auto sine    = [](double x, double y) { return y / std::hypot(x, y, 1); };
    const auto inverse = seen.invert({T(1.7), T(1.2), 1});
    CHECK(double(inverse.x) ==
          near(solid_angle(test::rectangle(1, 1.7, 0.5, 2, 1)).value() / 0.21207982090554895, 1e-5));
    CHECK(double(inverse.y) ==
          near((sine(1.7, 1.2) - sine(1.7, 0.5)) / (sine(1.7, 2) - sine(1.7, 0.5)), 1e-5));
    Rng rng{5, 0, 0, 0};
    for (int i = 0; i < 2000; ++i) {
        const auto u = square_point<T>(rng);
        const auto p = seen.sample(u);
        REQUIRE((p.x >= 1 && p.x <= 3 && p.y >= T(0.5) && p.y <= 2 && p.z == 1));
        REQUIRE(seen.pdf(p).value > 0);
        REQUIRE(std::abs(double(seen.invert(p).x - u.x)) <= 2e-5);
        REQUIRE(std::abs(double(seen.invert(p).y - u.y)) <= 2e-5);
    }
    CHECK(p_of_uniform([&](Rng& some) { return seen.invert(seen.sample(square_point<T>(some))); }) >
          significance);
    // points of the area, each as likely, are not
    CHECK(p_of_uniform([&](Rng& some) {
              const auto u = square_point<T>(some);
              return seen.invert({1 + 2 * u.x, T(0.5) + T(1.5) * u.y, 1});
          }) < 1e-6);
}
