/// @file boxes.cpp
/// Where the textbook's slabs fail: zeros of both signs, corners, boxes without thickness; and BoxRay beside them.

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <limits>

#include "../../chapters/04_boxes/aimed_at_boxes.hpp"
#include "../../chapters/04_boxes/textbook_slabs.hpp"
#include "scene/teapot.hpp"

using namespace sr;

namespace {

const Box<float> cube{Vec3(-1), Vec3(1)};
constexpr float  infinity = std::numeric_limits<float>::infinity();

/// Rays whose origin lies exactly on a slab's plane, with a zero along its axis.
const std::array<Ray<float>, 4> grazing{Ray<float>{{-1, 0, -5}, {0, 0, 1}},
                                        {{1, 0, -5}, {0, 0, 1}},
                                        {{-5, 0, -1}, {1, 0, 0}},
                                        {{-5, 0, 1}, {1, 0, 0}}};

bool is(Interval<float> interval, float min, float max) {
    return interval.min == min && interval.max == max;
}

/// From 4 to 6, of which the end is lengthened by a few roundings.
bool is_4_to_6(Interval<float> interval) {
    return interval.min == 4 && interval.max >= 6 && interval.max <= 6.00002F;
}

}  // namespace

TEST_CASE("S7: a ray in the plane of a face is lost by each textbook form, 0 times infinity") {
    const auto textbook = [](std::size_t ray, MinMax how) { return textbook_clip(grazing[ray], cube, how); };
    CHECK(is(textbook(0, MinMax::running_first), 4, 6));
    CHECK(is(textbook(1, MinMax::running_first), 4, -infinity));
    CHECK(is(textbook(2, MinMax::running_first), 4, 6));
    CHECK(is(textbook(3, MinMax::running_first), 4, -infinity));

    CHECK(is(textbook(0, MinMax::running_second), 4, 6));
    CHECK(is(textbook(1, MinMax::running_second), 4, -infinity));
    CHECK(std::isnan(textbook(2, MinMax::running_second).min));
    CHECK(std::isnan(textbook(2, MinMax::running_second).max));
    CHECK(is(textbook(3, MinMax::running_second), 4, -infinity));

    CHECK(is(textbook(0, MinMax::ieee), infinity, 6));
    CHECK(is(textbook(1, MinMax::ieee), 4, -infinity));
    CHECK(is(textbook(2, MinMax::ieee), infinity, 6));
    CHECK(is(textbook(3, MinMax::ieee), 4, -infinity));

    for (const auto& ray : grazing) {
        CHECK(is_4_to_6(BoxRay(ray).clip(cube, in_front<float>)));
        CHECK(is(padded_clip(ray, cube, 1.0F), 4, 6));
    }
}

TEST_CASE("S8: minus zero is not less than zero, and its reciprocal is minus infinity") {
    const Ray<float> ray{{0, 0, -5}, {-0.0F, 0, 1}};
    CHECK(is(clip_by_sign_of_direction(ray, cube), infinity, -infinity));
    CHECK(is(clip_by_sign_of_direction({{0, 0, -5}, {0, 0, 1}}, cube), 4, 6));
    CHECK(is_4_to_6(BoxRay(ray).clip(cube, in_front<float>)));
}

TEST_CASE("S9: rounding loses true hits at corners and edges, padding none") {
    const auto lost = [](BoxPart part) {
        return lost_hits(part, 0.01, 400'000, {1, double(ize_padding<float>)}, 0);
    };
    const LostHits corner = lost(BoxPart::corner), edge = lost(BoxPart::edge),
                   interior = lost(BoxPart::interior);
    CHECK(corner.padded[0] >= 11.24 / 3);  // the catalogue's rates, within a factor of 3
    CHECK(corner.padded[0] <= 11.24 * 3);
    CHECK(edge.padded[0] >= 4.81 / 3);
    CHECK(edge.padded[0] <= 4.81 * 3);
    CHECK(interior.padded[0] <= 0.01);
    for (const LostHits& place : {corner, edge, interior}) {
        CHECK(place.padded[1] == 0);
        CHECK(place.core == 0);
    }
}

TEST_CASE("S9: a hit of a triangle's vertex is lost by the triangle's own box, unless it is padded") {
    const LostHits lost = lost_vertices(convert<float>(teapot(8)), {1, double(ize_padding<float>)}, 0);
    CHECK(lost.padded[0] >= 1);
    CHECK(lost.padded[1] == 0);
    CHECK(lost.core == 0);
}

TEST_CASE("S56: the box of a flat light is never hit by a strict comparison, and always by the other") {
    Box<float> light;
    for (const auto& vertex : {Vec3{213, 548.8F, 227}, Vec3{343, 548.8F, 332}}) light.include(vertex);
    constexpr int rays   = 100'000;
    int           strict = 0, closed = 0, core = 0;
    for (int i = 0; i < rays; ++i) {
        Rng              rng{1, i, 0, 0};
        const float      u = rng.uniform(), v = rng.uniform();
        const Vec3       eye{278, 273, -800};
        const Ray<float> ray{eye, Vec3{213 + 130 * u, 548.8F, 227 + 105 * v} - eye};
        const auto       plain = padded_clip(ray, light, 1.0F);
        strict += plain.min < plain.max ? 1 : 0;
        closed += plain.min <= plain.max ? 1 : 0;
        core += BoxRay(ray).clip(light, in_front<float>).empty() ? 0 : 1;
    }
    CHECK(strict == 0);
    CHECK(closed == rays);
    CHECK(core == rays);
}
