/// @file optics.cpp
/// Rays through glass and water against the closed forms of classical optics, on chapter 7's optical bench.

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>
#include <tuple>

#include "../../chapters/07_recursion/optics.hpp"
#include "material/fresnel.hpp"
#include "math/degrees.hpp"
#include "near.hpp"

using namespace sr;
using test::near;

TEST_CASE("F3: critical angle, Snell's window and Brewster's angle, traced") {
    for (const auto& [n, critical, brewster] : {std::tuple{1.5, 41.810314895778598, 56.309932474020213},
                                                {4.0 / 3, 48.590377890729141, 53.130102354155979}}) {
        CHECK(degrees(critical_angle(n)) == near(critical));
        CHECK(degrees(right_angle_at(n)) == near(brewster));
        CHECK(fresnel(std::cos(radians(brewster)), n).p <= 1e-30);
        CHECK(fresnel(std::cos(radians(brewster + 1)), n).p >= 1e-5);
    }
    CHECK(degrees(2 * critical_angle(4.0 / 3)) == near(97.180755781458281));
}

TEST_CASE("F7: a prism turns light least where its way is symmetric") {
    const Prism prism;
    const auto  i = bracketed_root([&](double angle) { return prism.asymmetry(angle); },
                                  Interval<double>{radians(30), radians(80)});
    REQUIRE(i);
    CHECK(degrees(*i) == near(48.590377890729141));
    const double least = deviation(*prism.trace(*i));
    CHECK(degrees(least) == near(37.180755781458281));
    for (const double aside : {-0.1, -0.001, 0.001, 0.1}) CHECK(deviation(*prism.trace(*i + aside)) > least);
    CHECK(!prism.trace(radians(25)));  // reflected totally at the right face
}

TEST_CASE("F10: the primary rainbow is where drops turn light least") {
    const double n       = 4.0 / 3;
    const auto   turn_at = [&](double b) { return deviation(*through_drop(b, n)); };
    const double b       = 0.86066296582387042;
    CHECK(degrees(turn_at(b)) == near(137.97034113430231));
    CHECK(180 - degrees(turn_at(b)) == near(42.029658865697693));
    CHECK(std::abs(least_at(turn_at, 0.1, 0.99) - b) <= 1e-7);  // a valley is flat: half of the digits
    for (const double aside : {-0.01, 0.01}) CHECK(turn_at(b + aside) > turn_at(b));
    for (const double x : {0.05, 0.3, 0.7, 0.99}) {
        const double i = std::asin(x), r = std::asin(x / n);
        CHECK(turn_at(x) == near(std::numbers::pi + 2 * i - 4 * r));
    }
}

TEST_CASE("F13: a point under water seems less deep, and less from aside") {
    CHECK(apparent_depth(radians(60), 4.0 / 3) == near(0.49319696191607187));
    CHECK(apparent_depth(1e-6, 4.0 / 3) == near(0.75));
}

TEST_CASE("a plate moves a ray sideways by d sin(i - r) / cos r, and does not turn it") {
    for (const double angle : {10.0, 45.0, 60.0, 85.0}) {
        const double i = radians(angle), r = std::asin(std::sin(i) / 1.5);
        CHECK(plate_offset(i, 1.5) == near(std::sin(i - r) / std::cos(r)));
    }
}

TEST_CASE(
    "a ball lens has its focus n r / (2 (n - 1)) from its centre, and rays at a height h fall short of it") {
    // the ray keeps its distance h from the centre, and is turned by 2 (i - r)
    for (const double n : {1.5, 1.9}) {
        for (const double h : {0.1, 0.5, 0.9}) {
            const double crossing = h / std::sin(2 * (std::asin(h / 2) - std::asin(h / (2 * n))));
            CHECK(ball_lens_crossing(h, 2, n) == near(crossing));
            CHECK(crossing < n * 2 / (2 * (n - 1)));
        }
        // what is left of the aberration, c h^2, is taken out by two heights
        const double h         = 1e-3,
                     near_axis = (4 * ball_lens_crossing(h / 2, 2, n) - ball_lens_crossing(h, 2, n)) / 3;
        CHECK(near_axis == near(n * 2 / (2 * (n - 1))));
    }
}

TEST_CASE("a hollow mirror has its focus half way to its centre, and rays at a height h cross behind it") {
    for (const double h : {1e-6, 0.1, 0.5, 0.9}) {
        const double cosine = std::sqrt(1 - h * h);
        CHECK(axis_crossing(off_hollow_mirror(h, 1).back()) == near(1 / (2 * cosine)));
    }
}
