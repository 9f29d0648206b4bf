#include <doctest/doctest.h>

#include <cmath>
#include <initializer_list>
#include <limits>

#include "math/difference_of_products.hpp"
#include "math/extremes.hpp"
#include "math/frame.hpp"
#include "math/interval.hpp"
#include "math/power_of_two.hpp"

using namespace sr;

namespace {

/// The largest deviation of a frame from being orthonormal and right-handed.
double error_of(const Frame<float>& frame) {
    const Frame<double> f{frame.s, frame.t, frame.n};
    double              worst = length(cross(f.s, f.t) - f.n);
    for (const double dot_with_itself : {dot(f.s, f.s), dot(f.t, f.t)}) {
        worst = max_or_nan(worst, std::abs(dot_with_itself - 1));
    }
    for (const double dot_with_other : {dot(f.s, f.t), dot(f.s, f.n), dot(f.t, f.n)}) {
        worst = max_or_nan(worst, std::abs(dot_with_other));
    }
    return worst;
}

}  // namespace

TEST_CASE("an interval is closed and does not contain NaN") {
    const Interval<float> interval{1, 2};
    CHECK(interval.contains(1));
    CHECK(interval.contains(2));
    CHECK(!interval.contains(std::nextafter(2.0F, 3.0F)));
    CHECK(!interval.contains(std::numeric_limits<float>::quiet_NaN()));
    CHECK(!interval.empty());
    CHECK(!Interval<float>{1, 1}.empty());  // S56: a flat box is entered and left at the same t
    CHECK(Interval<float>{2, 1}.empty());
    CHECK(Interval<float>{std::numeric_limits<float>::quiet_NaN(), 1}.empty());
}

TEST_CASE("the worst of numbers of which one is NaN is NaN") {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    CHECK(max_or_nan(1.0, 2.0) == 2);
    CHECK(min_or_nan(1.0, 2.0) == 1);
    CHECK(std::isnan(max_or_nan(nan, 2.0)));
    CHECK(std::isnan(max_or_nan(1.0, nan)));
    CHECK(std::isnan(min_or_nan(nan, 2.0)));
    CHECK(std::isnan(min_or_nan(1.0, nan)));
}

TEST_CASE("a frame is orthonormal in every direction") {
    double worst = 0;
    for (int i = 0; i <= 2000; ++i) {
        for (const double phi : {0.0, 0.7, 2.0, 4.0}) {
            // Angles to -z from 0 to pi, dense near zero.
            const double theta = i == 0 ? 0.0 : std::acos(-1.0) * std::pow(10.0, -5.0 * (1 - i / 2000.0));
            const Vec3   n = Vector3<double>{std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi),
                                             -std::cos(theta)};
            worst          = max_or_nan(worst, error_of(frame_around(n)));
        }
    }
    CHECK(worst <= 4e-7);
}

TEST_CASE("a frame's local and world directions are inverse") {
    const auto            frame = frame_around(normalize(Vector3<double>{1, -2, -3}));
    const Vector3<double> w{0.3, -0.2, 0.9};
    CHECK(length(frame.to_world(frame.to_local(w)) - w) <= 1e-15);
    CHECK(length(frame.to_world({0, 0, 1}) - frame.n) <= 1e-15);
}

TEST_CASE("the difference of products keeps its sign where the plain one is zero") {
    // Stability S15: (1.0001, 1, 0) x (1, 0.9999, 0) in float.
    const float  a = 1.0001F, b = 0.9999F;
    const double exact = double{a} * double{b} - 1.0;
    CHECK(a * b - 1.0F * 1.0F == 0.0F);
    CHECK(std::abs(difference_of_products(a, b, 1.0F, 1.0F) / exact - 1) <= 1e-7);
    CHECK(difference_of_products(1.0F, 1.0F, a, b) > 0);
    CHECK(difference_of_products(3.0, 4.0, 2.0, 6.0) == 0.0);
}

TEST_CASE("a double that is rounded to float has been rounded, whatever the compiler packs together") {
    const volatile double given[] = {0.1, 0.2, 0.3};
    const Vector3<double> exact{given[0], given[1], given[2]};
    const Vec3            rounded(exact);
    const Vector3<double> back(rounded);
    CHECK(back.x == double(0.1F));
    CHECK(back.y == double(0.2F));
    CHECK(back.z == double(0.3F));
}

TEST_CASE_TEMPLATE("the largest power of two in a number", T, float, double) {
    using Limits = std::numeric_limits<T>;
    for (const T sign : {T(1), T(-1)}) {
        CHECK(power_of_two_in(sign) == 1);
        CHECK(power_of_two_in(sign * T(1.999)) == 1);
        CHECK(power_of_two_in(sign * T(-0.3)) == T(0.25));
        CHECK(power_of_two_in(sign * 1000) == 512);
        CHECK(power_of_two_in(sign * Limits::max()) == std::ldexp(T(1), Limits::max_exponent - 1));
        CHECK(power_of_two_in(sign * Limits::min()) == Limits::min());
        CHECK(power_of_two_in(sign * Limits::denorm_min()) == 0);
        CHECK(power_of_two_in(sign * 0) == 0);
        CHECK(power_of_two_in(sign * Limits::infinity()) == Limits::infinity());
    }
}
