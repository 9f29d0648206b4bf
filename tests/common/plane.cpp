/// @file plane.cpp
/// A ray meets a plane where (2.2) says, and no input makes a hit that is none.

#include "geometry/plane.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>

#include "law.hpp"
#include "vector_of.hpp"

using namespace sr;
using namespace sr::test;

TEST_CASE_TEMPLATE("G5 a ray meets a plane, also when it grazes it", T, float, double) {
    // n = (1, 2, 2) / 3 and n.p = 3: t = 3 / (n.d) is 3 / (5/3) = 9/5, and 3 / (2e-9 / 3) = 4.5e9.
    constexpr double eps   = std::numeric_limits<T>::epsilon();
    const Vector3<T> third = {T(1) / 3, T(2) / 3, T(2) / 3};
    for (const auto& plane :
         {Plane<T>{{1, 2, 2}, third}, Plane<T>{{1, 2, 2}, {1, 2, 2}}, Plane<T>{{9, 0, 0}, {-1, -2, -2}}}) {
        const auto steep = intersect(plane, {{0, 0, 0}, {1, 1, 1}});
        REQUIRE(steep);
        CHECK(std::abs(*steep - 1.8) <= 8 * eps * 1.8);
        const auto grazing = intersect(plane, {{0, 0, 0}, {2, -1, T(1e-9)}});
        REQUIRE(grazing);
        CHECK(std::abs(*grazing - 4.5e9) <= 8 * eps * 4.5e9);
    }
}

TEST_CASE("a ray that runs along a plane, or away from it, misses") {
    const Plane<float> floor{{0, 0, 1}, {0, 0, 1}};
    CHECK(!intersect(floor, {{0, 0, 2}, {1, 0, 0}}));
    CHECK(!intersect(floor, {{0, 0, 1}, {1, 0, 0}}));  // in it: 0 / 0
    CHECK(!intersect(floor, {{0, 0, 2}, {0, 0, 1}}));
    CHECK(!intersect(floor, {{0, 0, 0}, {1, 0, 1e-45F}}));  // t is beyond the type
    CHECK(intersect(floor, {{0, 0, 2}, {0, 0, -4}}) == 0.25F);
    CHECK(intersect(floor, {{0, 0, 0}, {0, 0, 4}}) == 0.25F);  // from behind as well
    CHECK(!intersect(floor, {{0, 0, 2}, {0, 0, -4}}, {0.5F, 1}));
}

TEST_CASE_TEMPLATE("laws of a ray and a plane", T, float, double) {
    check_law("near the plane's point, no digit of the distance is lost to where both are", [] {
        // On a lattice o - r is exact: moved together, the same hit to the bit.
        const auto       integers = rc::gen::map(rc::gen::inRange(-100, 101), [](int i) { return T(i); });
        const Vector3<T> r = vector_of(integers), n = vector_of(integers), o = vector_of(integers),
                         d = vector_of(integers), far = T(8192) * vector_of(integers);
        const auto here  = intersect(Plane<T>{r, n}, Ray<T>{o, d});
        const auto there = intersect(Plane<T>{r + far, n}, Ray<T>{o + far, d});
        RC_ASSERT(here == there);
    });
    check_law("no bit pattern gives a hit that is not finite or not in the range", [] {
        const auto     number = any_bits<T>();
        const Ray<T>   ray{vector_of(number), vector_of(number)};
        const Plane<T> plane{vector_of(number), vector_of(number)};
        const T        from = *number, to = *number;
        for (const auto& range : {in_front<T>, Interval<T>{from, to}}) {
            const auto t = intersect(plane, ray, range);
            RC_ASSERT((!t || (std::isfinite(*t) && range.contains(*t))));
        }
    });
}
