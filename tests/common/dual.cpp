#include "math/dual.hpp"

#include <doctest/doctest.h>

#include <cmath>

#include "law.hpp"

using namespace sr;
using namespace sr::test;

TEST_CASE("dual numbers know the product, quotient and chain rule") {
    // f = (x y - 2) / z + x^2 at (3, 4, 5): f = 11, df/dx = y/z + 2x, df/dy = x/z, df/dz = -(x y - 2)/z^2.
    const auto x = Dual<double>::variable(3, 0);
    const auto y = Dual<double>::variable(4, 1);
    const auto z = Dual<double>::variable(5, 2);
    const auto f = (x * y - 2.0) / z + square(x);
    CHECK(f.value == 11);
    CHECK(std::abs(f.derivative[0] - 6.8) <= 1e-14);
    CHECK(std::abs(f.derivative[1] - 0.6) <= 1e-14);
    CHECK(std::abs(f.derivative[2] + 0.4) <= 1e-14);

    // g = 1 / (z - y) - 2 z: dg/dy = 1, dg/dz = -3.
    const auto g = 1.0 / (z - y) - z * 2.0 + 0.5;
    CHECK(g.value == -8.5);
    CHECK(g.derivative == std::array{0.0, 1.0, -3.0});
}

TEST_CASE("a dual number's derivative is the polynomial's") {
    check_law("of any cubic", [] {
        const auto a = *finite<double>(), b = *finite<double>(), c = *finite<double>(), x = *finite<double>();
        const auto t = Dual<double, 1>::variable(x, 0);
        const auto f = t * square(t) * a + square(t) * b + t * c;
        // 3 a x^2 + 2 b x + c, to some units of the sum of its terms' sizes.
        const double expected = 3 * a * x * x + 2 * b * x + c;
        const double size     = std::abs(3 * a * x * x) + std::abs(2 * b * x) + std::abs(c);
        RC_ASSERT(std::abs(f.derivative[0] - expected) <= 1e-15 * size);
    });
}
