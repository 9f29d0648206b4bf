#include "math/bracketed_root.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "law.hpp"

using namespace sr;
using namespace sr::test;

namespace {

/// How often a method asks f.
template <class Method, class F>
int calls(Method&& method, F&& f) {
    int n = 0;
    method([&](auto t) {
        ++n;
        return f(t);
    });
    return n;
}

}  // namespace

TEST_CASE_TEMPLATE("a bracketed root is within two units in the last place, and bisection ends next to it", T,
                   float, double) {
    const T    root    = std::sqrt(T(2));  // of t^2 - 2, to half a unit
    const T    epsilon = std::numeric_limits<T>::epsilon();
    const auto f       = [](T t) { return t * t - 2; };
    for (const T end : {T(1.5), T(2), T(100), T(1e10)}) {
        const auto slow = bisect(f, Interval<T>{0, end});
        const auto fast = bracketed_root(f, Interval<T>{0, end});
        REQUIRE(slow);
        REQUIRE(fast);
        CHECK(std::abs(*slow - root) <= 2 * epsilon);
        CHECK(std::abs(*fast - root) <= 4 * epsilon);
        CHECK(f(*slow) <= 0);
        CHECK(f(std::nextafter(*slow, end)) > 0);
    }
}

TEST_CASE("a smooth function is asked a third as often as by bisection, a hostile one not without end") {
    const auto smooth  = [](double t) { return std::cos(t) - t; };
    const auto hostile = [](double t) {
        return t < 1e-300 ? -1e300 : 1e-300;
    };  // a jump that parabolas mistake
    const auto by = [](auto method, Interval<double> bracket) {
        return [=](auto f) { CHECK(method(f, bracket).has_value()); };
    };
    const auto slow = [](auto f, Interval<double> bracket) { return bisect(f, bracket); };
    const auto fast = [](auto f, Interval<double> bracket) { return bracketed_root(f, bracket); };
    CHECK(calls(by(fast, {0, 1}), smooth) <= 12);
    CHECK(calls(by(slow, {0, 1}), smooth) >= 36);
    CHECK(calls(by(fast, {-1e308, 1e308}), hostile) <= 2200);
}

TEST_CASE("without a strict change of sign there is no root, unless an end is one") {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    for (const auto& method :
         {+[](double (*f)(double), Interval<double> r) { return bisect(f, r); },
          +[](double (*f)(double), Interval<double> r) { return bracketed_root(f, r); }}) {
        CHECK(!method([](double t) { return t * t + 1; }, {-1, 1}));
        CHECK(!method([](double t) { return t > 0.5 ? std::nan("") : -1.0; }, {0, 1}));
        CHECK(!method([](double t) { return t > 0.25 && t < 0.75 ? std::nan("") : t - 0.6; }, {0, 1}));
        CHECK(!method([](double t) { return t; }, {1, -1}));
        CHECK(!method([](double t) { return t; }, {nan, 1}));
        CHECK(method([](double t) { return t; }, {0, 1}) == 0.0);
        CHECK(method([](double t) { return t - 1; }, {0, 1}) == 1.0);
        // The product of the two ends' values underflows to 0: who multiplies signs loses this root.
        const auto small = method([](double t) { return 1e-200 * (t - 0.3); }, {0, 1});
        REQUIRE(small);
        CHECK(std::abs(*small - 0.3) <= 1e-15);
    }
}

TEST_CASE("a root lies in its bracket, and f changes its sign at it") {
    check_law("of any cubic, in any bracket", [] {
        const auto            a = *any_bits<float>(), b = *any_bits<float>(), c = *any_bits<float>();
        const auto            x = *any_bits<float>(), y = *any_bits<float>();
        const auto            f = [&](float t) { return ((t + a) * t + b) * t + c; };
        const Interval<float> bracket{std::min(x, y), std::max(x, y)};
        const auto            slow = bisect(f, bracket), fast = bracketed_root(f, bracket);
        if (slow) {
            RC_ASSERT(bracket.contains(*slow));
            const float next = std::nextafter(*slow, bracket.max);
            RC_ASSERT((f(*slow) == 0 || opposite_signs(f(*slow), f(next)) || f(next) == 0));
        }
        if (fast) RC_ASSERT(bracket.contains(*fast));
    });
}
