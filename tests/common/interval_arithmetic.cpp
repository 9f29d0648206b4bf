#include "math/interval_arithmetic.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "law.hpp"

using namespace sr;
using namespace sr::test;

namespace {

/// Whether a float interval holds a number that double knows, for floats' operations, exactly or nearly so.
bool holds(Interval<float> interval, double exact) {
    return double(interval.min) <= exact && exact <= double(interval.max);
}

struct Sample {
    Interval<float> interval;
    float           inside;
};

/// Any finite interval, and a number in it.
Sample any_interval() {
    float n[3];
    for (float& x : n) {
        x = *any_bits<float>();
        RC_PRE(std::isfinite(x));
    }
    std::sort(n, n + 3);
    return {{n[0], n[2]}, n[1]};
}

}  // namespace

TEST_CASE("bounds are rounded outwards, at every size and at the ends of the type") {
    using Limits = std::numeric_limits<float>;
    for (const float x : {0.0F, 1.0F, -1.0F, 3.0F, 1e-30F, -1e30F, Limits::min(), Limits::denorm_min()}) {
        CHECK(rounded_down(x) < x);
        CHECK(rounded_up(x) > x);
    }
    CHECK(rounded_down(1.0F) >= 1 - 4 * Limits::epsilon());
    // What overflowed may have been a finite number.
    CHECK(rounded_down(Limits::infinity()) == Limits::max());
    CHECK(rounded_up(Limits::max()) == Limits::infinity());
    CHECK(rounded_up(-Limits::infinity()) == Limits::lowest());
}

TEST_CASE("an interval is as wide as it must be") {
    const auto near = [](Interval<double> a, double min, double max) {
        return std::abs(a.min - min) <= 1e-14 && std::abs(a.max - max) <= 1e-14 && a.min <= min &&
               max <= a.max;
    };
    const Interval<double> a{-1, 2}, b{3, 4};
    CHECK(near(a + b, 2, 6));
    CHECK(near(a - b, -5, -1));
    CHECK(near(a * b, -4, 8));
    CHECK(near(a / b, -1.0 / 3, 2.0 / 3));
    CHECK(near(a * a, -2, 4));     // which does not know that both are the same number,
    CHECK(near(square(a), 0, 4));  // and which does
    CHECK(near(square(-b), 9, 16));
    CHECK(near(a * -2.0, -4, 2));
    CHECK(near(1.0 / b - 1.0, -0.75, -2.0 / 3));
    CHECK((b / a).min == -std::numeric_limits<double>::infinity());
    CHECK((b / a).max == std::numeric_limits<double>::infinity());
    CHECK((whole_line<double> * Interval<double>{0, 0}).contains(1e300));  // 0 infinity: anything
}

TEST_CASE("an interval holds the result of every number in its operands") {
    check_law("of sums, differences, products, quotients, squares of any floats", [] {
        const auto [a, x] = any_interval();
        const auto [b, y] = any_interval();
        RC_ASSERT(holds(a + b, double(x) + double(y)));
        RC_ASSERT(holds(a - b, double(x) - double(y)));
        RC_ASSERT(holds(a * b, double(x) * double(y)));
        RC_ASSERT(holds(a * y, double(x) * double(y)));
        if (y != 0) RC_ASSERT(holds(a / b, double(x) / double(y)));
        RC_ASSERT(holds(square(a), double(x) * double(x)));
        RC_ASSERT(holds(-a, -double(x)));
        RC_ASSERT(holds(hull(a, b), x));
        RC_ASSERT(std::abs(x) <= magnitude(a));
    });
}

TEST_CASE("bounds rounded to nearest do not hold the result: the law above can fail") {
    const float third = 1.0F / 3.0F;
    CHECK(!holds({third, third}, 1.0 / 3));
    CHECK(holds(1.0F / Interval<float>{3, 3}, 1.0 / 3));
}
