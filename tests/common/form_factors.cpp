/// @file form_factors.cpp
/// Form factors against closed forms, and the laws that hold for all of them.

#include "radiosity/form_factors.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <stdexcept>
#include <tuple>
#include <vector>

#include "near.hpp"
#include "radiosity/closed_form_factors.hpp"
#include "radiosity/exchange_area.hpp"
#include "radiosity/point_form_factors.hpp"

using namespace sr;
using sr::test::near;

namespace {

using Point = Vector3<double>;

/// [0, a] x [0, b] at the height z, its front upwards.
Patch level(double a, double b, double z = 0) {
    return {{0, 0, z}, {a, 0, z}, {a, b, z}, {0, b, z}};
}

/// [0, b] x [0, h] in the plane x = 0, its front to +x.
Patch upright(double b, double h) {
    return {{0, 0, 0}, {0, b, 0}, {0, b, h}, {0, 0, h}};
}

Polygon grey(const Patch& shape) {
    return {shape, {0.5, 0.5, 0.5}, {}, 0};
}

/// The unit cube from inside, each face cut into n x n.
Patches cube(int n) {
    const Point                p[] = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0},
                                      {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};
    const std::vector<Polygon> faces{grey({p[0], p[1], p[2], p[3]}), grey({p[7], p[6], p[5], p[4]}),
                                     grey({p[0], p[4], p[5], p[1]}), grey({p[1], p[5], p[6], p[2]}),
                                     grey({p[2], p[6], p[7], p[3]}), grey({p[3], p[7], p[4], p[0]})};
    return cut(faces, 1.0 / n);
}

double exchange_of(const Patch& from, const Patch& to, double tolerance) {
    return exchange_area(from, to, tolerance) / from.area();
}

}  // namespace

TEST_CASE("C1: equal squares that face each other, in closed form") {
    for (const auto& [c, expected] :
         {std::tuple{1.0, 0.19982489569838738}, {0.1, 0.82699452239725658}, {10.0, 0.0031620568387576016}})
        CHECK(opposed_rectangles(1, 1, c) == near(expected, 1e-10));
    CHECK(opposed_rectangles(2, 3, 0.7) == near(opposed_rectangles(3, 2, 0.7), 1e-14));
    CHECK(opposed_rectangles(20, 30, 7) == near(opposed_rectangles(2, 3, 0.7), 1e-14));
    // the series meets the formula where it takes over
    CHECK(opposed_rectangles(1, 0.5, 30 * (1 + 1e-12)) ==
          near(opposed_rectangles(1, 0.5, 30 * (1 - 1e-12)), 1e-11));
}

TEST_CASE("C2, C3: rectangles at a right angle, in closed form") {
    CHECK(perpendicular_rectangles(1, 1, 1) == near(0.20004377607540315, 1e-13));
    CHECK(perpendicular_rectangles(1, 2, 3) == near(0.16169401433302758, 1e-13));
    CHECK(perpendicular_rectangles(2, 1, 0.5) == near(0.16685539497330043, 1e-13));
    CHECK(opposed_rectangles(1, 1, 1) + 4 * perpendicular_rectangles(1, 1, 1) == near(1, 1e-14));
}

TEST_CASE("C6: disks on one axis, in closed form") {
    CHECK(coaxial_disks(1, 1, 1) == near(0.38196601125010515, 1e-14));
    CHECK(coaxial_disks(1, 2, 1) == near(0.7639320225002103, 1e-14));
    CHECK(coaxial_disks(0.5, 1, 3) == near(0.097794236896834982, 1e-14));
    CHECK(coaxial_disks(1, 3, 0) == 1);
    CHECK(coaxial_disks(3, 1, 0) == near(1.0 / 9, 1e-15));
}

TEST_CASE("C1-C3: the exchange area meets the closed forms to its tolerance") {
    for (const double tolerance : {0.01, 1e-3, 1e-4, 1e-6}) {
        CAPTURE(tolerance);
        for (const double c : {0.1, 1.0, 10.0})
            CHECK(exchange_of(level(1, 1), level(1, 1, c).reversed(), tolerance) ==
                  near(opposed_rectangles(1, 1, c), tolerance));
        CHECK(exchange_of(level(1, 1), upright(1, 1), tolerance) == near(0.20004377607540315, tolerance));
        CHECK(exchange_of(level(2, 1), upright(1, 3), tolerance) == near(0.16169401433302758, tolerance));
        CHECK(exchange_of(level(1, 2), upright(2, 0.5), tolerance) == near(0.16685539497330043, tolerance));
    }
}

TEST_CASE("what is not seen from before, or does not look here, has no exchange") {
    CHECK(exchange_area(level(1, 1), level(1, 1, 1)) == 0);
    CHECK(exchange_area(level(1, 1, 1), level(1, 1).reversed()) == 0);
    CHECK(exchange_area(level(1, 1), level(2, 1)) == 0);
    const Patches    patches = cube(1);
    const Visibility visibility{mesh_of(patches).mesh};
    CHECK_THROWS_AS((void)form_factors(patches, visibility, {.tolerance = 0}), std::invalid_argument);
    CHECK_THROWS_AS((void)form_factors(patches, visibility, {.tolerance = std::nan("")}),
                    std::invalid_argument);
    CHECK_THROWS_AS((void)form_factors(patches, visibility, {.strata = 0}), std::invalid_argument);
}

TEST_CASE(
    "form factors of a cube's patches: rows add up to 1, reciprocity is exact, threads change nothing") {
    for (const int n : {1, 2, 4}) {
        CAPTURE(n);
        const Patches    patches = cube(n);
        const Visibility visibility{mesh_of(patches).mesh};
        const auto       F     = form_factors(patches, visibility);
        double           worst = 0, lopsided = 0;
        for (std::size_t i = 0; i < F.size(); ++i) {
            CHECK(F(i, i) == 0);
            worst = std::max(worst, std::abs(F.row_sum(i) - 1));
            for (std::size_t j = 0; j < F.size(); ++j)
                lopsided = std::max(lopsided, std::abs(patches.shapes[i].area() * F(i, j) -
                                                       patches.shapes[j].area() * F(j, i)));
        }
        CHECK(worst <= 1e-4);
        CHECK(lopsided <= 1e-16);
        const auto again = form_factors(patches, visibility, {}, {.threads = 7});
        for (std::size_t i = 0; i < F.size(); ++i) CHECK(std::ranges::equal(F.row(i), again.row(i)));
    }
}

TEST_CASE("from a point of a wall no piece of that wall is seen, however its corners are rounded") {
    for (const int n : {3, 5, 6, 7, 12}) {
        const Patches patches = cube(n);
        for (std::size_t i = 0; i < patches.size(); ++i) {
            const Patch& from = patches.shapes[i];
            double       sum  = 0;
            for (const auto& to : patches.shapes) {
                const double F = contour_form_factor(from.at({0.3, 0.7}), from.normal(), to);
                if (dot(from.normal(), to.normal()) > 0.5) CHECK(F == 0);
                sum += F;
            }
            CHECK(sum == near(1, 1e-12));
        }
    }
}
