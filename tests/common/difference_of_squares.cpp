/// @file difference_of_squares.cpp

#include "math/difference_of_squares.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <cstdint>
#include <limits>

#include "law.hpp"

using namespace sr;
using namespace sr::test;

TEST_CASE("a difference of squares keeps its digits where they cancel") {
    // 3, 4, 12, 13 is a Pythagorean quadruple; with 12.0001, float's nearest, the difference is what that adds.
    CHECK(difference_of_squares<float>({3, 4, 12}, 13) == 0);
    const float  z        = 12.0001F;
    const double expected = (double(z) - 12) * (double(z) + 12);
    CHECK(std::abs(difference_of_squares<float>({3, 4, z}, 13) / expected - 1) <= 6e-8);
    const Vec3 v{3, 4, z};
    CHECK(std::abs((dot(v, v) - 169) / expected - 1) >= 1e-4);
    CHECK(std::abs((length(v) - 13) * (length(v) + 13) / expected - 1) >= 1e-4);
}

TEST_CASE_TEMPLATE("laws of a difference of squares", T, float, double) {
    check_law("it is as right as with twice the digits, rounded", [] {
        // Integers that fit into T, but whose squares do not; 64 bits hold the exact difference.
        constexpr int      bits = sizeof(T) == 4 ? 23 : 30;
        const auto         any  = rc::gen::inRange<std::int64_t>(-(1 << bits), 1 << bits);
        const std::int64_t x = *any, y = *any, z = *any;
        // The nearest integer length, so that half of the digits cancel.
        const std::int64_t squares = x * x + y * y + z * z, r = std::int64_t(std::sqrt(double(squares)));

        const double eps   = double(std::numeric_limits<T>::epsilon());
        const double exact = double(squares - r * r);
        const double found = double(difference_of_squares<T>({T(x), T(y), T(z)}, T(r)));
        RC_ASSERT(std::abs(found - exact) <= eps * exact + eps * eps * double(squares));
    });
}
