#include "geometry/box.hpp"

#include <doctest/doctest.h>

#include <cmath>

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
}  // namespace

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
