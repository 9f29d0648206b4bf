#include "geometry/box.hpp"

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <limits>

#include "law.hpp"
#include "vector_of.hpp"

using namespace sr;

namespace {
const Box<float> cube{Vec3(-1), Vec3(1)};

Interval<float> clip(Vec3 origin, Vec3 direction, const Box<float>& box = cube) {
    return BoxRay<float>({origin, direction}).clip(box, in_front<float>);
}

/// Stated so that NaN is no miss: empty() holds for it.
bool misses(Vec3 origin, Vec3 direction, const Box<float>& box = cube) {
    const Interval<float> inside = clip(origin, direction, box);
    return inside.min > inside.max;
}

Vec3 finite_vector() {
    return test::vector_of(test::finite<float>());
}

Box<float> finite_box() {
    Box<float> box;
    for (int corner = 0; corner < 2; ++corner) box.include(finite_vector());
    return box;
}

bool equal(Interval<float> a, Interval<float> b) {
    return a.min == b.min && a.max == b.max;
}
}  // namespace

TEST_CASE("G3 the interval of a ray in a box: entry and exit by hand") {
    // The slabs of [-1, 1]^3 are passed in [2, 4], [2, 6] and [2, 14/3]. The exit is lengthened by 16
    // units in the last place on purpose, and 8 more are allowed.
    const auto inside = clip({-3, -2, -2.5F}, {1, 0.5F, 0.75F});
    CHECK(inside.min == 2);
    constexpr float epsilon = std::numeric_limits<float>::epsilon();
    CHECK(inside.max >= 4);
    CHECK(inside.max <= 4 * (1 + (16 + 8) * epsilon));
}

TEST_CASE("the interval of a ray in a box") {
    for (const float sign : {-1.0F, 1.0F}) {
        for (int axis = 0; axis < 3; ++axis) {
            Vec3 o(0.25F), d(0.0F);
            o[axis]           = -5 * sign;
            d[axis]           = sign;
            const auto inside = clip(o, d);
            CHECK(inside.min == 4);
            CHECK(std::abs(inside.max - 6) <= 1e-4F);
            CHECK(misses(o, -d));
        }
    }
    CHECK(misses({-5, 2, 0}, {1, 0, 0}));
    CHECK(clip({0, 0, 0}, {1, 1, 1}).min == 0);
    CHECK(misses({-2, 0, 0}, {1, 2, 0}));
    CHECK(clip({-3, -3, -3}, {1, 1, 1}).min == 2);
}

TEST_CASE("a box is closed: rays in the plane of a face, zeros of both signs, a box without thickness") {
    // Stability S7, S8 and S56.
    for (const float zero : {0.0F, -0.0F}) {
        for (const float edge : {-1.0F, 1.0F}) {
            for (const auto& inside :
                 {clip({edge, 0, -5}, {zero, zero, 1}), clip({-5, 0, edge}, {1, zero, zero}),
                  clip({edge, edge, -5}, {zero, zero, 1})}) {
                CHECK(inside.min == 4);
                CHECK(inside.max >= 6);
                CHECK(inside.max <= 6.0001F);
            }
            CHECK(misses({std::nextafter(edge, 2 * edge), 0, -5}, {zero, zero, 1}));
        }
    }
    const Box<float> light{{213, 548.8F, 227}, {343, 548.8F, 332}};
    const auto       seen = clip({278, 273, -800}, Vec3{250, 548.8F, 300} - Vec3{278, 273, -800}, light);
    CHECK(seen.min <= seen.max);
}

TEST_CASE("a box grows around points, and an empty one has no surface") {
    Box<float> box;
    CHECK(box.half_area() == 0);
    box.include(Vec3{1, 2, 3});
    box.include(Vec3{0, 4, 3});
    CHECK(box.min == Vec3{0, 2, 3});
    CHECK(box.max == Vec3{1, 4, 3});
    CHECK(box.half_area() == 2);
    CHECK(misses({0, 0, 0}, {1, 1, 1}, Box<float>{}));
}

TEST_CASE_TEMPLATE("laws of boxes: any bits give an interval without NaN, in the range that was asked for", T,
                   float, double) {
    test::check_law("clip", [] {
        const auto        any = test::any_bits<T>();
        const Box<T>      box{test::vector_of(any), test::vector_of(any)};
        const Ray<T>      ray{test::vector_of(any), test::vector_of(any)};
        const Interval<T> range{std::abs(*test::finite<T>()), std::abs(*test::finite<T>())};
        const auto        inside = BoxRay<T>(ray).clip(box, range);
        RC_ASSERT(inside.min >= range.min);
        RC_ASSERT(inside.max <= range.max);
    });
}

TEST_CASE("laws of boxes: the interval holds every t at which the ray is in the box") {
    test::check_law("a point of the ray, and a box around it", [] {
        const Vec3                o = finite_vector(), d = finite_vector();
        const float               t = std::abs(*test::finite<float>());
        const Vector3<double>     p = Vector3<double>(o) + double(t) * Vector3<double>(d);
        Box<float>                box;
        constexpr float           infinity = std::numeric_limits<float>::infinity();
        const std::array<Vec3, 3> points{Vec3(p), finite_vector(), finite_vector()};
        for (const auto& point : points) box.include(point);
        for (int axis = 0; axis < 3; ++axis) {  // p itself was rounded
            box.min[axis] = std::nextafter(box.min[axis], -infinity);
            box.max[axis] = std::nextafter(box.max[axis], infinity);
        }
        const auto inside = clip(o, d, box);
        RC_ASSERT(!inside.empty());
        RC_ASSERT(inside.max >= t);
        RC_ASSERT(inside.min <= t * (1 + 2 * std::numeric_limits<float>::epsilon()));
    });
}

TEST_CASE("laws of boxes: the names of the axes and their directions don't matter, to the bit") {
    test::check_law("permuted and mirrored", [] {
        const Box<float> box = finite_box();
        const Vec3       o = finite_vector(), d = finite_vector();
        const auto       turned = [](Vec3 v) { return Vec3{v.y, v.z, v.x}; };
        RC_ASSERT(equal(clip(turned(o), turned(d), {turned(box.min), turned(box.max)}), clip(o, d, box)));
        RC_ASSERT(equal(clip(-o, -d, {-box.max, -box.min}), clip(o, d, box)));
    });
}

TEST_CASE("laws of boxes: a larger box has no smaller interval and no smaller surface, to the bit") {
    test::check_law("include", [] {
        const Box<float> box    = finite_box();
        Box<float>       larger = box;
        larger.include(finite_vector());
        RC_ASSERT(larger.half_area() >= box.half_area());
        const Vec3 o = finite_vector(), d = box.centre() - o;
        const auto inside = clip(o, d, box);
        RC_PRE(!inside.empty());
        RC_ASSERT(clip(o, d, larger).min <= inside.min);
        RC_ASSERT(clip(o, d, larger).max >= inside.max);
    });
}
