/// @file implicit_roots.cpp
/// Where searches along a ray lose surfaces, or digits: rows S17 to S20 and S52.

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

#include "../../chapters/02_surfaces/loose_bounds.hpp"
#include "../../chapters/02_surfaces/squared_sphere.hpp"
#include "../../chapters/02_surfaces/textbook_quartic.hpp"
#include "catalogue.hpp"
#include "geometry/implicit_closed_form.hpp"
#include "geometry/implicit_ellipsoid.hpp"
#include "geometry/implicit_intervals.hpp"
#include "geometry/implicit_marching.hpp"
#include "geometry/implicit_segment_tracing.hpp"
#include "geometry/implicit_sphere_tracing.hpp"
#include "geometry/implicit_torus.hpp"
#include "sampling/rng.hpp"
#include "statistics/tests.hpp"

using namespace sr;

namespace {

constexpr double significance = 1e-4;

/// The unit sphere in bounds so wide that they don't tell where it is: steps begin anywhere.
const LooseBounds<Ellipsoid<double>, double> sphere{{{1, 1, 1}}, 6};

/// A ray that does meet the unit sphere, on one of its uniformly distributed chords, and a start of any phase.
struct Chord {
    Ray<double>      ray;
    Interval<double> range;
};

Chord random_chord(Rng& rng, double step) {
    const double b     = std::sqrt(rng.uniform<double>());  // of uniform points on a disk
    const double phase = rng.uniform<double>();
    return {{{-2.5, b, 0}, {1, 0, 0}}, {step * phase, 100}};
}

}  // namespace

TEST_CASE("S17: steps of length s miss s^2 / 12 of the unit sphere's chords, and interval arithmetic none") {
    constexpr int chords = 100'000;
    for (const auto& [step, catalogued] :
         {std::pair{1.0, 0.08310}, {0.5, 0.02078}, {0.2, 0.00330}, {0.1, 0.00084}}) {
        CAPTURE(step);
        Rng rng{17, 0, 0, 0};
        int missed = 0, missed_by_intervals = 0, missed_by_segments = 0, missed_by_formula = 0;
        for (int i = 0; i < chords; ++i) {
            const auto [ray, range] = random_chord(rng, step);
            missed += march(sphere, ray, range, step) ? 0 : 1;
            missed_by_intervals += bisect_intervals(sphere, ray, range, 1e-6) ? 0 : 1;
            missed_by_segments += segment_trace(sphere, ray, range, 1e-6) ? 0 : 1;
            missed_by_formula += solve(sphere, ray, range) ? 0 : 1;
        }
        // Chords of length l have the density l / 2, and the share 1 - l / s of those below s is missed.
        const double p    = step * step / 12;
        const double rate = missed / double(chords);
        CHECK(z_test(rate, std::sqrt(p * (1 - p) / chords), p).p > significance);
        CHECK(test::within_factor_3(rate, catalogued));
        CHECK(missed_by_intervals == 0);
        CHECK(missed_by_segments == 0);
        CHECK(missed_by_formula == 0);
    }
}

TEST_CASE("S18: steps of 0.1 miss a ring of wire, and neither quartic nor intervals do") {
    constexpr int rays = 20'000;
    for (const auto& [tube, probability] : {std::pair{0.1, 0.0}, {0.01, 0.80}, {0.001, 0.98}}) {
        CAPTURE(tube);
        const LooseBounds<Torus<double>, double> ring{{1, tube}, 6};
        Rng                                      rng{18, 0, 0, 0};
        int missed = 0, missed_by_formula = 0, missed_by_intervals = 0, missed_by_segments = 0;
        for (int i = 0; i < rays; ++i) {
            // Through the middle of the tube, at any angle around the axis.
            const double           phi = 6.28 * rng.uniform<double>();
            const Interval<double> range{0.1 * rng.uniform<double>(), 100};
            const Ray<double>      ray{{std::cos(phi), std::sin(phi), -1}, {0, 0, 1}};
            missed += march(ring, ray, range, 0.1) ? 0 : 1;
            missed_by_formula += solve(ring, ray, range) ? 0 : 1;
            missed_by_intervals += bisect_intervals(ring, ray, range, 1e-6) ? 0 : 1;
            missed_by_segments += segment_trace(ring, ray, range, 1e-6) ? 0 : 1;
        }
        const double rate = missed / double(rays);
        // 1 - 2 r / s, or 0, within 5 standard errors
        CHECK(std::abs(rate - probability) <= 5 * std::sqrt(probability * (1 - probability) / rays));
        CHECK(missed_by_formula == 0);
        CHECK(missed_by_intervals == 0);
        CHECK(missed_by_segments == 0);
    }
}

TEST_CASE("S19: a double root changes no sign, however small the steps") {
    const SquaredSphere    twice;
    const Ray<double>      axis{{-3, 0, 0}, {1, 0, 0}};
    const Interval<double> range{0, 6};
    CHECK(!march(twice, axis, range, 6e-5));  // 10^5 samples
    double least = 1;
    for (int i = 0; i < 100'000; ++i) least = std::min(least, on_ray(twice, axis, 6e-5 * i + 3e-5));
    CHECK(least >= 0);
    CHECK(least <= 3 * 1.6e-9);

    CHECK(march(sphere, axis, range, 0.1).value_or(0) == doctest::Approx(2).epsilon(1e-15));
    CHECK(std::abs(solve(twice, axis, range).value_or(0) - 2) <= 1e-7);
    CHECK(std::abs(solve(twice, axis, {2.5, 6}).value_or(0) - 4) <= 1e-7);
    CHECK(std::abs(bisect_intervals(twice, axis, range, 1e-9).value_or(0) - 2) <= 1e-6);
}

TEST_CASE("a step that ends on the surface hides a root from those who multiply the values' signs") {
    const Ray<double> axis{{-3, 0, 0}, {1, 0, 0}};
    const auto        f = [&](int t) { return on_ray(sphere, axis, double(t)); };
    REQUIRE(f(2) == 0);
    int changes = 0;
    for (int t = 0; t < 6; ++t) changes += f(t) * f(t + 1) < 0 ? 1 : 0;
    CHECK(changes == 0);
    CHECK(march(sphere, axis, {0, 6}, 1.0) == 2.0);
    CHECK(march(sphere, axis, {2.5, 6}, 0.5) == 4.0);
}

TEST_CASE(
    "S20: a value of f taken for a distance leads through the surface, divided by a Lipschitz bound it never "
    "does") {
    const auto&       f = sphere;  // |p|^2 - 1
    const Ray<double> axis{{-5, 0, 0}, {1, 0, 0}};
    double            t = 0;
    for (int i = 0; i < 2; ++i) t += on_ray(f, axis, t);  // 24, and then 360 more
    CHECK(t == 384.0);

    // On the segment up to the other side |grad f| = 2 |x| <= 10: the first step is 24 / 10.
    const double bound = lipschitz_bound(f, Box<double>{{-5, 0, 0}, {5, 0, 0}});
    CHECK(std::abs(on_ray(f, axis, 0.0) / bound - 2.4) <= 1e-6);
    const auto hit = sphere_trace(f, axis, {0, 100}, bound, 1e-9);
    CHECK(std::abs(hit.value_or(0) - 4) <= 1e-8);
    CHECK(std::abs(segment_trace(f, axis, {0, 100}, 1e-9).value_or(0) - 4) <= 1e-8);
}

TEST_CASE("S52: t += dt stands still at t = 10^5 in float, t0 + i dt does not") {
    const float start = 1e5F, step = 1e-3F;
    float       t = start;
    for (int i = 0; i < 1000; ++i) t += step;
    CHECK(t - start == 0.0F);
    CHECK(start + 1000 * step - start == doctest::Approx(1).epsilon(0.01));

    // Marching in such steps through what is 10^5 away arrives.
    const Ellipsoid<float> small{{0.5F, 0.5F, 0.5F}};
    const Ray<float>       ray{{-1e5F, 0, 0}, {1, 0, 0}};
    CHECK(std::abs(march(small, ray, in_front<float>, step).value_or(0) - 99999.5F) <= 0.0157F);
}

namespace {

/// f of the torus R = 2, r = 0.5 along a level line, and the number of its roots: at a height z the torus is the ring
/// between two circles.
template <class T>
struct LevelLine {
    Polynomial<T, 4> f;
    std::size_t      roots;
};

template <class T>
LevelLine<T> random_level_line(Rng& rng) {
    const T      z    = T(0.5) * rng.uniform<T>();
    const T      x    = T(2.5) * rng.uniform<T>();
    const T      from = rng.uniform<T>();
    const double half = std::sqrt(0.25 - double(z) * double(z));
    const auto   f    = Torus<T>{2, T(0.5)}.f(Polynomial<T, 1>{{x, 0}}, Polynomial<T, 1>{{from, 1}},
                                              Polynomial<T, 1>{{z, 0}});
    return {f, std::size_t(x < 2 - half ? 4 : x < 2 + half ? 2 : 0)};
}

/// How many of 20 000 level lines have not the number of roots that they should have.
template <class T, class Roots>
int wrong_counts(const Roots& roots) {
    int wrong = 0;
    Rng rng{24, 0, 0, 0};
    for (int i = 0; i < 20'000; ++i) {
        const auto line = random_level_line<T>(rng);
        wrong += roots(line.f).count == line.roots ? 0 : 1;
    }
    return wrong;
}

template <class T>
int wrong_counts_of_isolation() {
    return wrong_counts<T>([](const auto& p) { return roots_in(p, Interval<T>{-4, 4}); });
}

template <class T>
int wrong_counts_of_ferrari() {
    return wrong_counts<T>([](const auto& p) { return textbook_quartic_roots(p); });
}

}  // namespace

TEST_CASE(
    "Ferrari's formula gets level rays wrong that meet a torus, and roots between extrema are not lost") {
    // A level line's quartic is even about a point. Up to rounding: the formula divides by a number that should be 0.
    CHECK(wrong_counts_of_ferrari<float>() > 20'000 / 20);
    CHECK(wrong_counts_of_ferrari<double>() > 20'000 / 20);
    CHECK(wrong_counts_of_isolation<float>() == 0);
    CHECK(wrong_counts_of_isolation<double>() == 0);
}
