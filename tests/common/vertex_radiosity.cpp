/// @file vertex_radiosity.cpp
/// Radiosity that varies within patches: linear functions stay as they are, up to the border and in any shape.

#include "radiosity/vertex_radiosity.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "near.hpp"
#include "patch_shapes.hpp"
#include "radiosity/corner_weights.hpp"

using namespace sr;
using sr::test::grey;
using sr::test::near;

namespace {

using Point = Vector3<double>;

const Patch rectangle{{1, 2, 3}, {4, 2, 3}, {4, 4, 3}, {1, 4, 3}};
const Patch trapezoid{{0, 0, 0}, {4, 0, 0}, {2, 1, 0}, {0, 1, 0}};
const Patch narrow{{0, 0, 0}, {4, 0, 0}, {0.05, 3, 0}, {0, 1, 0}};
const Patch triangle{{0, 0, 1}, {3, 1, 0}, {0, 1.5, 2}};

DoubleSpectrum linear(const Point& p) {
    return {20 + p.x - 2 * p.y + p.z, 30 - 3 * p.x, 7};
}

Radiosities at_centres(const Patches& patches) {
    Radiosities values;
    for (const auto& shape : patches.shapes) values.push_back(linear(shape.centre()));
    return values;
}

/// The largest difference from the linear function at a grid of points of all patches.
double worst(const Patches& patches, const Radiosities& at_vertices) {
    double most = 0;
    for (std::size_t i = 0; i < patches.size(); ++i)
        for (const double s : {0.0, 0.3, 1.0})
            for (const double t : {0.0, 0.6, 1.0}) {
                const Point p          = patches.shapes[i].at({s, t});
                const auto  difference = interpolated(patches, at_vertices, i, p) - linear(p);
                for (const double channel : {difference.r, difference.g, difference.b})
                    most = std::abs(channel) <= most ? most : std::abs(channel);
            }
    return most;
}

}  // namespace

TEST_CASE("corners' weights: they are those of the point, up to the corners") {
    for (const Patch& patch : {rectangle, trapezoid, narrow, triangle, narrow.reversed()}) {
        for (const double s : {0.0, 0.25, 0.99, 1.0}) {
            for (const double t : {0.0, 0.5, 0.875, 1.0}) {
                CAPTURE(s);
                CAPTURE(t);
                const Point p       = patch.at({s, t});
                const auto  weights = corner_weights(patch, p);
                Point       mean{0, 0, 0};
                double      sum = 0;
                for (std::size_t k = 0; k < 4; ++k) {
                    CHECK(weights[k] >= -1e-12);
                    sum += weights[k];
                    mean += weights[k] * patch.corners()[std::min(k, patch.corners().size() - 1)];
                }
                CHECK(sum == near(1, 1e-14));
                CHECK(length(mean - p) < 1e-13);
                if (patch.corners().size() == 4) CHECK(std::abs(weights[2] - s * t) < 1e-12);
            }
        }
    }
}

TEST_CASE("vertex radiosities: what is linear in a polygon is reproduced, in cuts of all shapes") {
    for (const Patch& shape : {rectangle, trapezoid, narrow, triangle}) {
        for (const double size : {1.0, 0.7, 0.31}) {
            CAPTURE(size);
            const Patches patches = cut(std::vector{grey(shape)}, size);
            CHECK(worst(patches, vertex_radiosities(patches, at_centres(patches))) < 1e-11);
        }
    }
    // what the means of the touching patches do at the border: half a patch's slope is lost
    const Patches patches = cut(std::vector{grey(rectangle)}, 1);
    const auto    values  = at_centres(patches);
    CHECK(std::abs(values[0].g - linear(patches.vertices[0]).g) == near(1.5));
    CHECK(worst(patches, Radiosities(patches.vertices.size(), values[0])) > 1);
}

TEST_CASE("vertex radiosities: level where nothing is known, no neighbours' light, and none below 0") {
    const Patches one = cut(std::vector{grey(rectangle)}, 10);
    for (const auto& B : vertex_radiosities(one, {{1, 2, 3}})) CHECK(B == DoubleSpectrum{1, 2, 3});

    const Patch   strip{{0, 0, 0}, {3, 0, 0}, {3, 1, 0}, {0, 1, 0}};
    const Patches three = cut(std::vector{grey(strip)}, 1);
    const auto    along = vertex_radiosities(three, {{1, 0, 5}, {2, 1, 1}, {3, 5, 0}});
    for (std::size_t i = 0; i < along.size(); ++i) {
        CHECK(along[i].r == near(0.5 + three.vertices[i].x));
        CHECK(along[i].g >= 0);
        CHECK(along[i].b >= 0);
    }
    CHECK(along[0].g == 0);  // the plane has 2 - 2.5 * 1.5 there

    const Patches two = cut(std::vector{grey(rectangle), grey(rectangle.reversed())}, 10);
    const auto    own = vertex_radiosities(two, {{1, 1, 1}, {9, 9, 9}});
    for (std::size_t i = 0; i < own.size(); ++i) CHECK(own[i].r == (i < 4 ? 1 : 9));

    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    CHECK(std::isnan(vertex_radiosities(one, {{nan, 2, 3}})[0].r));
}
