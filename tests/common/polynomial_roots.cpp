#include "math/polynomial_roots.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "law.hpp"
#include "sampling/rng.hpp"

using namespace sr;
using namespace sr::test;

namespace {

/// (t - a) (t - b) (t - c) (t - d) scale.
template <class T>
Polynomial<T, 4> with_roots(T a, T b, T c, T d, T scale = 1) {
    const auto factor = [](T root) { return Polynomial<T, 1>{{-root, 1}}; };
    return factor(a) * factor(b) * factor(c) * factor(d) * scale;
}

template <class T>
constexpr Interval<T> everywhere{T(-1e3), T(1e3)};

}  // namespace

TEST_CASE("polynomials are added, multiplied, squared, derived and evaluated") {
    const Polynomial<double, 1> p{{1, 2}};
    const Polynomial<double, 2> q{{3, 0, -1}};
    CHECK((p * q).c == std::array{3.0, 6.0, -1.0, -2.0});
    CHECK((p + q).c == std::array{4.0, 2.0, -1.0});
    CHECK((q - p).c == std::array{2.0, -2.0, -1.0});
    CHECK(square(p).c == std::array{1.0, 4.0, 4.0});
    CHECK((p / 2.0 - 1.0).c == std::array{-0.5, 1.0});
    CHECK((p * q).derivative().c == std::array{6.0, -2.0, -6.0});
    CHECK((p * q)(2.0) == -5.0);
    CHECK(q.magnitude(-2.0) == 7.0);
}

TEST_CASE_TEMPLATE("a quartic's roots are found, ascending, in the range only", T, float, double) {
    const auto p     = with_roots<T>(-3, 1, 2, 7, T(0.5));
    const auto close = [](T a, T b) { return std::abs(a - b) <= 64 * std::numeric_limits<T>::epsilon(); };
    const auto all   = roots_in(p, everywhere<T>);
    REQUIRE(all.count == 4);
    const std::array<T, 4> expected{-3, 1, 2, 7};
    for (std::size_t i = 0; i < 4; ++i) CHECK(close(all.root[i], expected[i]));

    const auto some = roots_in(p, {0, 3});
    REQUIRE(some.count == 2);
    CHECK(close(some.root[0], 1));
    CHECK(close(*first_root(p, {T(1.5), 100}), 2));
    CHECK(!first_root(p, {3, 6}));
    CHECK(!first_root(p, {2, 1}));
}

TEST_CASE_TEMPLATE("a double root is found once, and so is one that rounding would hide", T, float, double) {
    const T    sqrt_epsilon = std::sqrt(std::numeric_limits<T>::epsilon());
    const auto twice        = roots_in(with_roots<T>(T(0.3), T(0.3), 5, 6), everywhere<T>);
    REQUIRE(twice.count == 3);
    // A double root is known to the square root of the precision only.
    CHECK(std::abs(twice.root[0] - T(0.3)) <= 8 * sqrt_epsilon);
    CHECK(roots_in(square(Polynomial<T, 2>{{T(-0.7), 0, 1}}), everywhere<T>).count == 2);

    // Rounding lifts a quarter of these off 0, and more.
    int found = 0;
    for (int i = 1; i <= 200; ++i) {
        const T    root = T(i) / 77;
        const auto p    = square(Polynomial<T, 1>{{-root, 1}}) * Polynomial<T, 2>{{3, 1, 1}};
        found += std::abs(first_root(p, everywhere<T>).value_or(-1) - root) <= 8 * sqrt_epsilon ? 1 : 0;
    }
    CHECK(found == 200);

    // (t^2 + 1)^2 has no real root; t^4 one, and nothing about it is simple.
    CHECK(roots_in(square(Polynomial<T, 2>{{1, 0, 1}}), everywhere<T>).count == 0);
    CHECK(first_root(Polynomial<T, 4>{{0, 0, 0, 0, 1}}, everywhere<T>) == T(0));
}

TEST_CASE("what has vanishing leading coefficients is a polynomial all the same, and NaN has no roots") {
    CHECK(first_root(Polynomial<double, 4>{{-6, 2, 0, 0, 0}}, everywhere<double>) == 3.0);
    CHECK(roots_in(Polynomial<double, 4>{{-4, 0, 1, 0, 0}}, everywhere<double>).count == 2);
    CHECK(std::abs(*first_root(Polynomial<double, 4>{{-8, 0, 0, 1, 0}}, everywhere<double>) - 2) <= 1e-15);
    CHECK(!first_root(Polynomial<double, 4>{{1, 0, 0, 0, 0}}, everywhere<double>));
    CHECK(!first_root(Polynomial<double, 4>{{std::nan(""), 1, 2, 3, 4}}, everywhere<double>));
    CHECK(!first_root(Polynomial<double, 4>{{1, 2, 3, std::nan(""), 4}}, everywhere<double>));
}

TEST_CASE_TEMPLATE("of random quartics no root that stands apart is missed, and none is invented", T, float,
                   double) {
    Rng rng{1, 0, 0, 0};
    int wrong = 0, worst_count = 0;
    T   worst = 0;
    for (int i = 0; i < 20000; ++i) {
        // Four roots in [-4, 4] at least 0.1 apart; else another four.
        std::array<T, 4> root{};
        for (T& r : root) r = T(8) * rng.uniform<T>() - 4;
        std::sort(root.begin(), root.end());
        bool apart = true;
        for (std::size_t k = 1; k < 4; ++k) apart = apart && root[k] - root[k - 1] > T(0.1);
        if (!apart) continue;
        const auto found = roots_in(with_roots(root[0], root[1], root[2], root[3]), everywhere<T>);
        ++worst_count;
        if (found.count != 4) {
            ++wrong;
            continue;
        }
        for (std::size_t k = 0; k < 4; ++k) {
            // Coefficients rounded by eps sum |c t^k| move a root by that over the slope there.
            T slope = 1, size = 1;
            for (std::size_t j = 0; j < 4; ++j) {
                if (j != k) slope *= std::abs(root[k] - root[j]);
                size *= std::abs(root[k]) + std::abs(root[j]);
            }
            worst = std::max(worst, std::abs(found.root[k] - root[k]) * slope / size);
        }
    }
    CHECK(worst_count > 10000);
    CHECK(wrong == 0);
    CHECK(worst <= 8 * std::numeric_limits<T>::epsilon());
}

TEST_CASE("any coefficients at all give finite roots in the range, or none") {
    check_law("of quartics and quadratics", [] {
        Polynomial<float, 4> p;
        Polynomial<float, 2> q;
        for (float& c : p.c) c = *any_bits<float>();
        std::copy(p.c.begin(), p.c.begin() + 3, q.c.begin());
        const auto            a = *finite<float>(), b = *finite<float>();
        const Interval<float> range{std::min(a, b), std::max(a, b)};
        const auto            of_p = roots_in(p, range);
        for (const float root : of_p) RC_ASSERT(range.contains(root));
        RC_ASSERT(std::is_sorted(of_p.begin(), of_p.end()));
        for (const float root : roots_in(q, range)) RC_ASSERT(range.contains(root));
    });
}
