/// @file directions.cpp
/// Directions near their limits: a frame beside its singular direction, an angle near 0, a vector too small or
/// too large to be squared.

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <tuple>
#include <utility>

#include "catalogue.hpp"
#include "law.hpp"
#include "math/angle.hpp"
#include "math/extremes.hpp"
#include "math/frame.hpp"
#include "math/unit.hpp"
#include "sampling/ball.hpp"
#include "sampling/rng.hpp"

using namespace sr;
using namespace sr::test;

namespace {

/// Frisvad's frame (2012): one division fewer to explain, and a singular direction.
Frame<float> frisvad(Vec3 n) {
    const float a = 1 / (1 + n.z);
    const float b = -n.x * n.y * a;
    return {{1 - n.x * n.x * a, b, -n.x}, {b, 1 - n.y * n.y * a, -n.y}, n};
}

/// The worst of the six scalar products' deviations from 0 and 1.
float deviation(const Frame<float>& f) {
    float worst = 0;
    for (const auto& [a, b, expected] :
         {std::tuple{f.s, f.s, 1.0F}, {f.t, f.t, 1.0F}, {f.s, f.t, 0.0F}, {f.s, f.n, 0.0F}, {f.t, f.n, 0.0F}})
        worst = max_or_nan(worst, std::abs(dot(a, b) - expected));
    return worst;
}

}  // namespace

TEST_CASE("S23 a frame beside -z: Frisvad's loses all its digits, the core's none") {
    for (const auto& [theta, published] :
         {std::pair{1e-1, 9.9e-6F}, {1e-2, 7e-4F}, {3e-3, 0.027F}, {1e-3, 0.2F}}) {
        float textbook = 0, cured = 0;
        for (int i = 0; i < 1000; ++i) {
            const double phi = 2 * std::numbers::pi * i / 1000;
            const Vec3   n(Vector3<double>{std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi),
                                           -std::cos(theta)});
            textbook = max_or_nan(textbook, deviation(frisvad(n)));
            cured    = max_or_nan(cured, deviation(frame_around(n)));
        }
        CAPTURE(theta);
        CHECK(within_factor_3(textbook, published));
        CHECK(cured <= 3e-7F);
    }

    float textbook = 0, cured = 0;
    Rng   rng{23, 0, 0, 0};
    for (int i = 0; i < 1'000'000; ++i) {
        const Vec3 n = normalize(in_unit_ball<float>(rng));
        textbook     = max_or_nan(textbook, deviation(frisvad(n)));
        cured        = max_or_nan(cured, deviation(frame_around(n)));
    }
    CHECK(textbook >= 0.01F);  // the worst of so few that come near to -z
    CHECK(cured <= 1e-6F);
    CHECK(!(deviation(frisvad({0, 0, -1})) <= 1));  // 1 / 0
    CHECK(deviation(frame_around(Vec3{0, 0, -1})) == 0);
}

TEST_CASE("S24 the angle between neighbours: acos(a.b) is NaN or noise, the core's keeps its digits") {
    constexpr int rays       = 100'000;
    int           beyond_one = 0, not_a_number = 0, off_by_half = 0, same_is_not_zero = 0;
    float         worst = 0;
    Rng           rng{24, 0, 0, 0};
    for (int i = 0; i < rays; ++i) {
        const Vec3 a = normalize(in_unit_ball<float>(rng));
        const Vec3 b = normalize(a + 1.4e-4F * frame_around(a).s);
        beyond_one += dot(a, a) > 1 ? 1 : 0;
        not_a_number += std::isnan(std::acos(dot(a, b))) ? 1 : 0;
        same_is_not_zero += angle_between(a, a) == 0 ? 0 : 1;

        const Vector3<double> da(a), db(b);
        const double          exact    = std::atan2(length(cross(da, db)), dot(da, db));
        const double          textbook = std::acos(double(std::min(dot(a, b), 1.0F)));
        off_by_half += std::abs(textbook / exact - 1) >= 0.5 ? 1 : 0;
        worst = max_or_nan(worst, float(std::abs(double(angle_between(a, b)) - exact) / exact));
    }
    CHECK(within_factor_3(beyond_one / double(rays), 0.190));
    CHECK(within_factor_3(not_a_number / double(rays), 0.132));
    CHECK(off_by_half >= rays / 3);
    CHECK(same_is_not_zero == 0);
    CHECK(worst <= 1e-3F);
}

TEST_CASE("S53 a vector too small or too large to be squared has a direction all the same") {
    const float half = std::numbers::sqrt2_v<float> / 2;
    for (const float size : {1e-45F, 1e-40F, 1e-23F, 1.0F, 1e20F, 3e38F}) {
        const Vec3 v{size, size, 0};
        const auto n = unit(v);
        REQUIRE(n);
        CHECK(std::abs(n->x - half) <= 1e-7F);
        CHECK(std::abs(n->y - half) <= 1e-7F);
        CHECK(n->z == 0);
    }
    CHECK(!(length(normalize(Vec3{1e-23F, 1e-23F, 0})) <= 2));  // infinity and NaN
    CHECK(length(normalize(Vec3{1e20F, 1e20F, 0})) == 0);
}

TEST_CASE_TEMPLATE("a vector of any bits has a direction or none, never a NaN", T, float, double) {
    check_law("unit(v) is nothing or of length 1", [] {
        const T    x = *any_bits<T>(), y = *any_bits<T>(), z = *any_bits<T>();
        const auto n      = unit(Vector3<T>{x, y, z});
        const bool finite = std::isfinite(x) && std::isfinite(y) && std::isfinite(z);
        RC_ASSERT((n.has_value() == (finite && (x != 0 || y != 0 || z != 0))));
        if (n) RC_ASSERT(std::abs(length(*n) - 1) <= 4 * std::numeric_limits<T>::epsilon());
    });
}
