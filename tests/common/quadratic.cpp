/// @file quadratic.cpp
/// Roots are roots, in order, with all their digits; and the school's formula's are not.

#include "math/quadratic.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>

#include "law.hpp"

using namespace sr;
using namespace sr::test;

namespace {

/// (-b - sqrt(b^2 - a c)) / a, as it is learnt by heart.
float lower_root_of_the_school(float a, float b, float c) {
    return (-b - std::sqrt(b * b - a * c)) / a;
}

}  // namespace

TEST_CASE("both roots have their digits where the school's formula has none") {
    // t^2 - 20000 t + 1: the roots' product is 1, and their sum 20000, so the lower one is 1 / 19999.99995.
    const auto roots = quadratic_roots(1.0F, -1e4F, 1.0F);
    REQUIRE(roots);
    CHECK(std::abs(roots->first / 5.0000000125e-5F - 1) <= 2e-7F);
    CHECK(roots->second == 2e4F);
    CHECK(lower_root_of_the_school(1, -1e4F, 1) == 0);
}

TEST_CASE_TEMPLATE("special quadratics", T, float, double) {
    const auto touching = quadratic_roots<T>(1, -3, 9);
    REQUIRE(touching);
    CHECK(touching->first == 3);
    CHECK(touching->second == 3);

    const auto symmetric = quadratic_roots<T>(1, 0, -4);
    REQUIRE(symmetric);
    CHECK(symmetric->first == -2);
    CHECK(symmetric->second == 2);

    const auto through_zero = quadratic_roots<T>(-1, 2, 0);
    REQUIRE(through_zero);
    CHECK(through_zero->first == 0);
    CHECK(through_zero->second == 4);

    const auto linear = quadratic_roots<T>(0, 2, -12);
    REQUIRE(linear);
    CHECK(linear->first == 3);
    CHECK(linear->second == 3);

    const auto square = quadratic_roots<T>(5, 0, 0);
    REQUIRE(square);
    CHECK(square->first == 0);
    CHECK(square->second == 0);

    CHECK(!quadratic_roots<T>(1, 0, 4));
    CHECK(!quadratic_roots<T>(0, 0, 1));
    CHECK(!quadratic_roots<T>(0, 0, 0));
}

TEST_CASE("a double root is told from none and from two by the last digit of a coefficient") {
    // b^2 = a c with 4095^2 = 16769025, which float holds, and a c = 4 * 4095^2 / 4.
    const float a = 4, b = 4095, c = 16'769'025.0F / 4;
    const auto  touching = quadratic_roots(a, b, c);
    REQUIRE(touching);
    CHECK(touching->first == -1023.75F);
    CHECK(touching->second == -1023.75F);
    CHECK(!quadratic_roots(a, b, std::nextafter(c, 2 * c)));
    const auto two = quadratic_roots(a, b, std::nextafter(c, 0.0F));
    REQUIRE(two);
    CHECK(two->first < two->second);

    // 4097^2 = 16785409 is odd and beyond 2^24: rounding makes it 16785408, and the plain discriminant 0.
    const float large = 4097, product = large * large;
    CHECK(large * large - 1.0F * product == 0);
    const auto apart = quadratic_roots(1.0F, large, product);
    REQUIRE(apart);
    CHECK(apart->second - apart->first >= 1.9F);  // 2 sqrt(1)
}

TEST_CASE_TEMPLATE("laws of a quadratic's roots", T, float, double) {
    constexpr long double eps = std::numeric_limits<T>::epsilon();
    check_law("their product is c / a and their sum -2 b / a", [] {
        const T    a = *nonzero<T>(), b = *finite<T>(), c = *finite<T>();
        const auto roots = quadratic_roots(a, b, c);
        RC_PRE(roots.has_value());
        const long double first = roots->first, second = roots->second;
        RC_ASSERT(first <= second);
        RC_ASSERT(std::abs(first * second * a - c) <= 8 * eps * std::abs(c));
        RC_ASSERT(std::abs(a * (first + second) + 2 * (long double)(b)) <=
                  8 * eps * std::abs(a) * (std::abs(first) + std::abs(second)));
    });
    check_law("a quadratic whose ends differ in sign has two", [] {
        const T a = *nonzero<T>(), b = *finite<T>(), c = -std::copysign(*nonzero<T>(), a);
        RC_ASSERT(quadratic_roots(a, b, c).has_value());
        RC_ASSERT(quadratic_roots(a, b, c)->first < 0);
        RC_ASSERT(quadratic_roots(a, b, c)->second > 0);
    });
    check_law("a power of two in t, or before all of it, changes no digit", [] {
        const T    a = *finite<T>(), b = *finite<T>(), c = *finite<T>();
        const T    k     = std::ldexp(T(1), *rc::gen::inRange(-8, 8));
        const auto roots = quadratic_roots(a, b, c);
        const auto same  = quadratic_roots(a * k, b * k, c * k);
        const auto far   = quadratic_roots(a, b * k, c * k * k);
        RC_ASSERT(same.has_value() == roots.has_value());
        RC_ASSERT(far.has_value() == roots.has_value());
        if (!roots) return;
        RC_ASSERT(same->first == roots->first);
        RC_ASSERT(same->second == roots->second);
        RC_ASSERT(far->first == roots->first * k);
        RC_ASSERT(far->second == roots->second * k);
    });
    check_law("turned around, the roots change sign and place", [] {
        const T    a = *finite<T>(), b = *nonzero<T>(), c = *finite<T>();
        const auto roots = quadratic_roots(a, b, c);
        const auto back  = quadratic_roots(a, -b, c);
        RC_ASSERT(back.has_value() == roots.has_value());
        if (!roots) return;
        RC_ASSERT(back->first == -roots->second);
        RC_ASSERT(back->second == -roots->first);
    });
    check_law("no bit pattern gives a root that is NaN, and what is in a range is finite", [] {
        const T    a = *any_bits<T>(), b = *any_bits<T>(), c = *any_bits<T>();
        const auto roots = quadratic_roots(a, b, c);
        RC_PRE(roots.has_value());
        RC_ASSERT(roots->first <= roots->second);
        const auto some = roots->first_in({});
        RC_ASSERT((!some || (std::isfinite(*some) && *some >= 0)));
    });
}
