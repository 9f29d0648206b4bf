#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include "../../chapters/02_surfaces/squared_sphere.hpp"
#include "geometry/implicit_closed_form.hpp"
#include "geometry/implicit_ellipsoid.hpp"
#include "geometry/implicit_hyperboloid.hpp"
#include "geometry/implicit_intervals.hpp"
#include "geometry/implicit_marching.hpp"
#include "geometry/implicit_metaballs.hpp"
#include "geometry/implicit_segment_tracing.hpp"
#include "geometry/implicit_sphere_tracing.hpp"
#include "geometry/implicit_surface.hpp"
#include "geometry/implicit_tanglecube.hpp"
#include "geometry/implicit_torus.hpp"
#include "law.hpp"
#include "sampling/rng.hpp"
#include "vector_of.hpp"

using namespace sr;
using namespace sr::test;

namespace {

/// Roots one after the other: each search begins a little behind the hit before.
template <class T, class Method>
std::vector<T> all_roots(const Method& first) {
    std::vector<T>   roots;
    Interval<T>      range{};
    std::optional<T> root;
    while ((root = first(range)) && roots.size() < 10) {
        roots.push_back(*root);
        range.min = *root + T(0.01);
    }
    return roots;
}

/// Checks a surface's roots on a ray against closed forms, found in three ways that keep all digits.
/// @param condition  how many times larger the relative error of a root is than that of what is given
template <class T, class Surface>
void check_roots(const Surface& surface, const Ray<T>& ray, const std::vector<double>& expected,
                 double condition) {
    const double tolerance = 8 * double(std::numeric_limits<T>::epsilon()) * condition;
    const auto   check     = [&](const std::vector<T>& roots) {
        REQUIRE(roots.size() == expected.size());
        for (std::size_t i = 0; i < roots.size(); ++i) {
            CAPTURE(expected[i]);
            CHECK(std::abs(double(roots[i]) / expected[i] - 1) <= tolerance);
        }
    };
    check(all_roots<T>([&](Interval<T> range) { return march(surface, ray, range, T(0.05)); }));
    check(all_roots<T>([&](Interval<T> range) { return bisect_intervals(surface, ray, range, T(0)); }));
    check(all_roots<T>([&](Interval<T> range) { return solve(surface, ray, range); }));
}

template <class T>
Metaballs<T> three_balls() {
    return {{{{T(-0.9), 0, 0}, T(0.9)}, {{T(0.9), T(0.1), 0}, T(0.8)}, {{0, T(0.8), T(0.4)}, T(0.6)}},
            T(0.5)};
}

/// A random ray from a sphere of radius 6 through a box.
template <class T>
Ray<T> ray_through(const Box<T>& box, Rng& rng) {
    std::array<T, 6> u{};
    for (T& number : u) number = rng.uniform<T>();
    const auto target = box.min + Vector3<T>{u[0], u[1], u[2]} * box.size();
    const auto origin = T(6) * normalize(Vector3<T>{u[3], u[4], u[5]} - T(0.5));
    return {origin, target - origin};
}

/// Calls `check` with each of the five surfaces.
template <class T, class Check>
void for_each_surface(const Check& check) {
    check(Ellipsoid<T>{{2, 1, 3}});
    check(Hyperboloid<T>{{1, T(0.8), T(1.2)}, 2});
    check(Torus<T>{2, T(0.5)});
    check(Tanglecube<T>{});
    check(three_balls<T>());
}

/// A plane at x = 4, written so that intervals of it are ten million times as wide as they need be.
struct HardlyAPlane {
    template <class Number>
    auto f(const Number& x, const Number&, const Number&) const {
        return square(x) - square(x) + (x - 4.0) * 1e-7;
    }
    Box<double> bounds() const { return {Vector3<double>(0), Vector3<double>(8)}; }
};

}  // namespace

TEST_CASE_TEMPLATE("G4 roots of torus and ellipsoid are those of their closed forms", T, float, double) {
    // In the torus' plane x = -+(R +- r), and at height z = -+(R +- sqrt(r^2 - z^2)). Relative errors of the origin 5,
    // of R = 2 and of r = 0.5, and one of d, move t = 2.5 by (5 + 2 + 0.5) / 2.5 + 1 times as much; no other more.
    const Torus<T> torus{2, T(0.5)};
    check_roots<T>(torus, {{-5, 0, 0}, {1, 0, 0}}, {2.5, 3.5, 6.5, 7.5}, 4);
    // sqrt(r^2 - z^2) = 0.4 adds (r^2 + z^2) / 0.4 = 0.85 to the 7 above.
    check_roots<T>(torus, {{-5, 0, T(0.3)}, {1, 0, 0}}, {2.6, 3.4, 6.6, 7.4}, 4.02);
    // x = -+ 2 sqrt(1 - y^2 - z^2 / 9) = -+ sqrt(2): 5, and by a, b, c, y and z sqrt(2) + 2 (1/2 + 1/2) 2 / sqrt(2).
    check_roots<T>(Ellipsoid<T>{{2, 1, 3}}, {{-5, T(0.5), T(1.5)}, {1, 0, 0}},
                   {3.585786437626905, 6.414213562373095}, 1 + 9.25 / 3.5858);
}

TEST_CASE("G4 a double root is found by intervals and by the polynomial, and lost by marching") {
    const SquaredSphere    twice;
    const Ray<double>      axis{{-3, 0, 0}, {1, 0, 0}};
    const Interval<double> all{};
    CHECK(!march(twice, axis, all, 1e-3));
    CHECK(std::abs(solve(twice, axis, all).value_or(0) - 2) <= 1e-7);
    CHECK(std::abs(bisect_intervals(twice, axis, all, 1e-9).value_or(0) - 2) <= 1e-6);
    const double steepest = lipschitz_bound(twice, Box<double>{Vector3<double>(-1.5), Vector3<double>(1.5)});
    CHECK(std::abs(sphere_trace(twice, axis, {1.5, 6}, steepest, 1e-6).value_or(0) - 2) <= 0.02);
}

TEST_CASE("intervals that give up say where, and that is not behind the root") {
    const Ray<double> ray{{-1, 2, 2}, {1, 0, 0}};
    const auto        doubt = bisect_intervals(HardlyAPlane{}, ray, in_front<double>, 1e-12);
    REQUIRE(doubt);
    CHECK(*doubt > 1);
    CHECK(*doubt <= 5);
    CHECK(std::abs(march(HardlyAPlane{}, ray, in_front<double>, 0.3).value_or(0) - 5) <= 1e-6);
}

TEST_CASE("the t of a direction of any length counts in that length") {
    const Torus<float> torus{2, 0.5F};
    for (const float length_of_d : {1e-6F, 1e-3F, 1.0F, 1e3F, 1e6F}) {
        const Ray<float> ray{{-5, 0, 0}, {length_of_d, 0, 0}};
        for (const auto root :
             {solve(torus, ray, in_front<float>), march(torus, ray, in_front<float>, 0.05F / length_of_d),
              bisect_intervals(torus, ray, in_front<float>, 0.0F)}) {
            CHECK(std::abs(root.value_or(0) * length_of_d - 2.5F) <= 1e-5F);
        }
    }
}

TEST_CASE_TEMPLATE("all methods find the same first root, but where a ray grazes", T, float, double) {
    constexpr int rays = 2000;
    const T       fine = T(64) * std::numeric_limits<T>::epsilon();
    for_each_surface<T>([&](const auto& surface) {
        Rng       rng{3, 0, 0, 0};
        const T   lipschitz = lipschitz_bound(surface, surface.bounds());
        const Box wide      = surface.bounds();
        int       hits = 0, marching = 0, spheres = 0, segments = 0, closed = 0;
        for (int i = 0; i < rays; ++i) {
            const auto ray  = ray_through<T>(wide, rng);
            const auto root = bisect_intervals(surface, ray, in_front<T>, fine);
            hits += root ? 1 : 0;
            const auto same = [&](std::optional<T> other, T tolerance) {
                return root.has_value() == other.has_value() &&
                       (!root || std::abs(*root - *other) <= tolerance);
            };
            marching += same(march(surface, ray, in_front<T>, T(1e-3)), T(1e-3)) ? 0 : 1;
            spheres += same(sphere_trace(surface, ray, in_front<T>, lipschitz, T(1e-5)), T(3e-3)) ? 0 : 1;
            segments += same(segment_trace(surface, ray, in_front<T>, T(1e-5)), T(3e-3)) ? 0 : 1;
            if constexpr (AlgebraicSurface<std::remove_cvref_t<decltype(surface)>, T>)
                closed += same(solve(surface, ray, in_front<T>), T(1e-3)) ? 0 : 1;
        }
        CHECK(hits > rays / 5);
        CHECK(hits < rays);
        CHECK(marching <= rays / 500);
        CHECK(spheres <= rays / 100);
        CHECK(segments <= rays / 100);
        CHECK(closed <= rays / 500);
    });
}

TEST_CASE("with a tolerance below the rounding errors of f, segment tracing loses no ray") {
    // Near a root |f| is rounding error, 10^-5 here, and over a slope of 1 that is a step through the root.
    const Torus<float>  torus{2, 0.5F};
    const Torus<double> exact{2, 0.5};
    Rng                 rng{6, 0, 0, 0};
    int                 lost = 0;
    for (int i = 0; i < 10'000; ++i) {
        const auto ray = ray_through(torus.bounds(), rng);
        const auto root =
            bisect_intervals(exact, Ray<double>{ray.origin, ray.direction}, in_front<double>, 1e-9);
        const auto found = segment_trace(torus, ray, in_front<float>, 1e-6F);
        lost += root && !(found && *found <= *root + 0.01) ? 1 : 0;
    }
    CHECK(lost == 0);
}

TEST_CASE("the gradient by dual numbers is the one by hand") {
    check_law("of the torus", [] {
        const double          R = std::abs(*nonzero<double>()), r = std::abs(*nonzero<double>());
        const Vector3<double> p{*finite<double>(), *finite<double>(), *finite<double>()};
        const auto            g = gradient(Torus<double>{R, r}, p);
        // 4 p (|p|^2 + R^2 - r^2) - 8 R^2 (x, y, 0), each term rounded at its own size.
        const double          sum = dot(p, p) + (R - r) * (R + r), size = dot(p, p) + R * R + r * r;
        for (int k = 0; k < 3; ++k) {
            const double by_hand = 4 * p[k] * sum - (k < 2 ? 8 * R * R * p[k] : 0);
            RC_ASSERT(std::abs(g[k] - by_hand) <= 2e-15 * std::abs(p[k]) * (4 * size + 8 * R * R));
        }
    });
}

TEST_CASE(
    "bounds hold the surface: f is positive on their faces and beyond, or the surface is cut off there") {
    Rng rng{4, 0, 0, 0};
    for_each_surface<double>([&](const auto& surface) {
        const auto box = surface.bounds();
        for (int i = 0; i < 3000; ++i) {
            Vector3<double> p{rng.uniform<double>(), 0, 0};
            p.y            = rng.uniform<double>();
            p.z            = rng.uniform<double>();
            p              = box.min + p * box.size();
            const int axis = i % 3;
            p[axis]        = (i % 2 == 0 ? box.min : box.max)[axis] * (1 + 1e-9);
            if (std::is_same_v<std::remove_cvref_t<decltype(surface)>, Hyperboloid<double>> && axis == 2)
                continue;
            CHECK(surface.f(p.x, p.y, p.z) > 0);
        }
    });
}

TEST_CASE("intervals hold f and its derivative at every point of a piece, and so does the Lipschitz bound") {
    Rng rng{5, 0, 0, 0};
    for_each_surface<float>([&](const auto& surface) {
        const float lipschitz = lipschitz_bound(surface, surface.bounds());
        for (int i = 0; i < 2000; ++i) {
            const auto            ray  = ray_through<float>(surface.bounds(), rng);
            const float           from = rng.uniform(), long_ = rng.uniform();
            const Interval<float> piece{from, from + 0.5F * long_};
            const auto            bounds = bounds_on_ray(surface, ray, piece);
            const float           t      = piece.min + (piece.max - piece.min) * 0.37F;
            const auto            at_t   = on_ray(surface, ray, Dual<float, 1>::variable(t, 0));
            CHECK(bounds.value.contains(at_t.value));
            CHECK(bounds.derivative[0].contains(at_t.derivative[0]));
            const auto g = gradient(surface, surface.bounds().min + rng.uniform() * surface.bounds().size());
            CHECK(length(g) <= lipschitz);
        }
    });
}

namespace {

template <class T>
void ends_with_a_finite_root(std::optional<T> root, Interval<T> range) {
    if (root) RC_ASSERT((std::isfinite(*root) && range.contains(*root)));
}

}  // namespace

TEST_CASE_TEMPLATE("any bits as ray, surface and effort end with a finite root in the range, or none", T,
                   float, double) {
    const auto try_all = [](const auto& surface, const Ray<T>& ray, Interval<T> range) {
        const T effort = *any_bits<T>();
        ends_with_a_finite_root(march(surface, ray, range, effort), range);
        ends_with_a_finite_root(sphere_trace(surface, ray, range, *any_bits<T>(), effort), range);
        ends_with_a_finite_root(segment_trace(surface, ray, range, effort), range);
        ends_with_a_finite_root(bisect_intervals(surface, ray, range, effort), range);
        if constexpr (AlgebraicSurface<std::remove_cvref_t<decltype(surface)>, T>)
            ends_with_a_finite_root(solve(surface, ray, range), range);
    };
    check_law(
        "of five surfaces",
        [&] {
            const bool wild = *rc::gen::arbitrary<bool>();  // or only somewhat strange
            const auto any  = [&] {
                return wild ? vector_of(any_bits<T>()) : Vector3<T>{*finite<T>(), *finite<T>(), 1};
            };
            const Ray<T>      ray{any(), any()};
            const T           a = std::abs(*any_bits<T>());
            const Interval<T> range{a >= 0 ? a : T(0),
                                    *rc::gen::arbitrary<bool>() ? in_front<T>.max : T(1e4)};
            try_all(Ellipsoid<T>{any()}, ray, range);
            try_all(Hyperboloid<T>{any(), any().x}, ray, range);
            try_all(Torus<T>{any().x, any().y}, ray, range);
            try_all(Tanglecube<T>{any().x}, ray, range);
            try_all(Metaballs<T>{{{any(), any().x}, {any(), any().y}}, any().x}, ray, range);
        },
        300);
}
