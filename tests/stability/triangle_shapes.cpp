/// @file triangle_shapes.cpp
/// Triangles that are small, flat, thin or far away (catalogue rows S12 to S16).

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>
#include <vector>

#include "../../chapters/03_triangles/shapes.hpp"
#include "../../chapters/03_triangles/textbook.hpp"
#include "geometry/area_of_sides.hpp"
#include "geometry/moeller_trumbore.hpp"
#include "geometry/plane_triangle.hpp"
#include "geometry/triangle.hpp"
#include "math/difference_of_products.hpp"

using namespace sr;

namespace {

/// Relative, to what is right.
double error(double value, double right) {
    return std::abs(value / right - 1);
}

/// What becomes of rays at triangles that are so far from the origin.
struct FarAway {
    double percent_missed;
    double median_error;  ///< of u, where it was hit
};

/// @param local  coordinates are counted from the triangle's own origin before they are rounded
FarAway far_away(double offset, bool local) {
    constexpr int       rays   = 50'000;
    int                 missed = 0;
    std::vector<double> errors;
    for (int i = 0; i < rays; ++i) {
        const auto [triangle, ray, uv] = random_shot(i);
        const Vector3<double>    moved(offset), origin = local ? moved : Vector3<double>(0);
        const auto               rounded = [&](Vector3<double> p) { return Vec3((p + moved) - origin); };
        const TriangleRay<float> seen({rounded(ray.origin), Vec3(ray.direction)});
        const auto               hit =
            seen.intersect({rounded(triangle.a), rounded(triangle.b), rounded(triangle.c)}, in_front<float>);
        missed += hit ? 0 : 1;
        if (hit) errors.push_back(std::abs(double(hit->uv.x) - uv.x));
    }
    const auto middle = errors.begin() + std::ptrdiff_t(errors.size() / 2);
    std::nth_element(errors.begin(), middle, errors.end());
    return {100.0 * missed / rays, *middle};
}

}  // namespace

TEST_CASE("S12 an absolute epsilon loses small triangles") {
    // A right triangle with legs s, head-on through its interior: |det| = s^2.
    const auto hit_with = [](float s, float epsilon) {
        const Triangle<float> triangle{{0, 0, 0}, {s, 0, 0}, {0, s, 0}};
        return textbook::intersect(triangle, {{s / 4, s / 4, 1}, {0, 0, -1}}, in_front<float>, epsilon)
            .has_value();
    };
    for (const auto& [s, coarse, middle, fine] : {std::tuple{1e-1F, true, true, true},
                                                  {1e-2F, false, true, true},
                                                  {1e-3F, false, true, true},
                                                  {1e-4F, false, false, false},
                                                  {1e-5F, false, false, false}}) {
        CAPTURE(s);
        CHECK(hit_with(s, 1e-3F) == coarse);
        // The catalogue's 1e-6 and 1e-8 are the dets of s = 1e-3 and 1e-4 themselves, up to rounding. A hundredth to
        // the side on which the catalogue has them, it no longer matters how they are rounded.
        CHECK(hit_with(s, 0.99e-6F) == middle);
        CHECK(hit_with(s, 1.01e-8F) == fine);
        CHECK(hit_with(s, 0));

        const Triangle<float> triangle{{0, 0, 0}, {s, 0, 0}, {0, s, 0}};
        const Ray<float>      ray{{s / 4, s / 4, 1}, {0, 0, -1}};
        CHECK(intersect_moeller_trumbore(triangle, ray, in_front<float>));
        CHECK(PlaneTriangle<float>(triangle).intersect(ray, in_front<float>));
        CHECK(TriangleRay<float>(ray).intersect(triangle, in_front<float>));
    }
}

TEST_CASE_TEMPLATE("S13 a triangle without area is a hit at NaN where NaN makes no miss", T, float, double) {
    const Triangle<T> line{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}};
    const Ray<T>      ray{{T(0.5), 0, 1}, {0, 0, -1}};
    const auto        wrong = textbook::intersect(line, ray, in_front<T>, T(0));
    REQUIRE(wrong);
    CHECK(std::isnan(wrong->t));

    CHECK(!intersect_moeller_trumbore(line, ray, in_front<T>));
    CHECK(!PlaneTriangle<T>(line).intersect(ray, in_front<T>));
    CHECK(!TriangleRay<T>(ray).intersect(line, in_front<T>));
}

TEST_CASE("S14 Heron's formula loses the area of a needle") {
    // The areas to nine digits, of the sides as they are rounded to float, from Heron's formula with 60 digits.
    CHECK(std::abs(textbook::heron(100000.0, 99999.99979, 0.00029) - 9.99999981) <= 1e-8);
    CHECK(error(area_of_sides(100000.0, 99999.99979, 0.00029), 10.0000001) <= 1e-8);
    CHECK(error(textbook::heron(1.0, 1.0, 1e-13), 5e-14) >= 0.0008 / 3);
    CHECK(error(area_of_sides(1.0, 1.0, 1e-13), 5e-14) <= 1e-15);
    for (const auto& [side, right, lost] : {std::tuple{1e-4F, 4.99999987e-05, 1e-3},
                                            {1e-6F, 4.99999999e-07, 0.046},
                                            {1e-7F, 5.00000006e-08, 1.0}}) {
        CAPTURE(side);
        CHECK(error(textbook::heron(1.0F, 1.0F, side), right) >= lost / 3);
        CHECK(error(textbook::heron(1.0F, 1.0F, side), right) <= lost * 3);
        CHECK(error(area_of_sides(1.0F, 1.0F, side), right) <= 1.2e-7);
        CHECK(area_of_sides(side, 1.0F, 1.0F) == area_of_sides(1.0F, side, 1.0F));
    }
    CHECK(area_of_sides(5.0, 3.0, 4.0) == 6.0);
    CHECK(std::isnan(area_of_sides(1.0, 1.0, 3.0)));
}

TEST_CASE(
    "S15 the cross product of nearly parallel vectors loses its sign, and Kahan's difference of products "
    "keeps it") {
    const float ax = 1.0001F, ay = 1, bx = 1, by = 0.9999F;
    const float plain_first = ax * by, plain_second = ay * bx;
    CHECK(plain_first - plain_second == 0);
    // The exact value of the rounded factors: both products are of 48 digits, which double holds.
    const double right = double(ax) * double(by) - double(ay) * double(bx);
    CHECK(error(right, -1.00033191e-08) <= 1e-8);
    CHECK(error(difference_of_products(ax, by, ay, bx), right) <= 1e-7);
}

TEST_CASE("S16 a triangle far from the origin is missed, and in its own coordinates it is not") {
    // The catalogue's median is NaN at 1e6, where misses counted as such. 0.05: floats there are 1/16 apart, so that
    // corners move by up to 1/32 along each axis, and u by about that over a triangle's size.
    for (const auto& [offset, missed, moved] :
         {std::tuple{1e2, 0.01, 4.3e-6}, {1e4, 0.84, 5.5e-4}, {1e6, 20.53, 0.05}}) {
        CAPTURE(offset);
        const auto world = far_away(offset, false);
        CHECK(world.percent_missed >= missed / 3);
        CHECK(world.percent_missed <= missed * 3);
        CHECK(world.median_error >= moved / 3);
        CHECK(world.median_error <= moved * 3);
        const auto local = far_away(offset, true);
        CHECK(local.percent_missed <= 0.01);
        CHECK(local.median_error <= 2e-7);
    }
    CHECK(far_away(0, false).percent_missed <= 0.01);
    CHECK(far_away(0, false).median_error <= 6e-7);
}
