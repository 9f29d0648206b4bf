/// @file spherical_triangles.cpp
/// Directions to small triangles: what row S33 does to a sampler that relies on the angles' excess.

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <concepts>
#include <limits>

#include "../../chapters/05_light/textbook_solid_angles.hpp"
#include "math/square.hpp"
#include "near.hpp"
#include "radiometry/polygon_solid_angle.hpp"
#include "sampling/rng.hpp"
#include "sampling/spherical_triangle.hpp"

using namespace sr;
using test::near;

namespace {

/// The triangle with right-angled legs s at the distance 1, by its unit directions, as Arvo's method begins.
template <std::floating_point T>
struct Legs {
    explicit Legs(T s) : a{0, 0, 1}, b{normalize(Vector3<T>{s, 0, 1})}, c{normalize(Vector3<T>{0, s, 1})} {}
    Vector3<T> a, b, c;
};

/// A direction to a triangle of unit directions, as Arvo printed it in 1995.
template <std::floating_point T>
Vector3<T> arvo_1995(const Legs<T>& of, Vector2<T> u) {
    const auto& [A, B, C] = of;
    const auto angle      = [](const Vector3<T>& at, const Vector3<T>& p, const Vector3<T>& q) {
        return std::acos(std::clamp(dot(normalize(cross(at, p)), normalize(cross(at, q))), T{-1}, T{1}));
    };
    const auto upright = [](const Vector3<T>& p, const Vector3<T>& to) {
        return normalize(p - dot(p, to) * to);
    };
    const T alpha = angle(A, B, C);
    const T area  = u.x * girard_solid_angle(Triangle<T>{A, B, C});
    const T s = std::sin(area - alpha), t = std::cos(area - alpha);
    const T U = t - std::cos(alpha), V = s + std::sin(alpha) * dot(A, B);
    const T q = ((V * t - U * s) * std::cos(alpha) - V) / ((V * s + U * t) * std::sin(alpha));

    const Vector3<T> end = q * A + std::sqrt(1 - q * q) * upright(C, A);
    const T          z   = 1 - u.y * (1 - dot(end, B));
    return z * B + std::sqrt(1 - z * z) * upright(end, B);
}

/// The points of the triangle, by their weights, that a sampler draws with the numbers u.
template <std::floating_point T>
Vector2<double> cured(T s, Vector2<T> u) {
    return Vector2<double>(SphericalTriangle<T>({0, 0, 1}, {s, 0, 1}, {0, s, 1}).sample(u));
}
template <std::floating_point T>
Vector2<double> textbook(T s, Vector2<T> u) {
    const auto w = Vector3<double>(arvo_1995(Legs<T>(s), {u.y, u.x}));
    return Vector2<double>{w.x, w.y} / w.z / double(s);
}

/// The share of points that lie somewhere else, by more than a tenth of the legs, than in exact arithmetic, or nowhere.
template <std::floating_point T, class Sample>
double misplaced(T s, const Sample& sample, double tolerance = 0.1) {
    constexpr int draws = 20'000;
    Rng           rng{61, 0, 0, 0};
    int           count = 0;
    for (int i = 0; i < draws; ++i) {
        const float           x = rng.uniform(), y = rng.uniform();
        const Vector2<double> exact = cured<long double>(s, {x, y});
        const Vector2<double> found = sample(s, Vector2<T>{x, y});
        count += !(length(found - exact) <= tolerance);
    }
    return double(count) / draws;
}

}  // namespace

TEST_CASE(
    "S33: Arvo's method as printed loses triangles below 10^-3 in float and 10^-7 in double; half tangents "
    "none") {
    struct Row {
        double legs, in_float, in_double;  // shares of draws misplaced, as measured when this was written
    };
    const auto as_printed = [](auto s, auto u) { return textbook(s, u); };
    const auto by_halves  = [](auto s, auto u) { return cured(s, u); };
    for (const auto& [legs, in_float, in_double] :
         {Row{1, 0, 0}, Row{1e-2, 0, 0}, Row{1e-3, 0.31, 0}, Row{3e-4, 1, 0}, Row{1e-6, 1, 0},
          Row{1e-8, 1, 1}, Row{1e-16, 1, 1}}) {
        CAPTURE(legs);
        CHECK(std::abs(misplaced(float(legs), as_printed) - in_float) <= 0.1);
        CHECK(std::abs(misplaced(legs, as_printed) - in_double) <= 0.1);
        CHECK(misplaced(float(legs), by_halves, 1e-6) == 0);
        CHECK(misplaced(legs, by_halves, 2e-15) == 0);
    }
}

TEST_CASE_TEMPLATE("S33: the half tangents last until the product of four lengths underflows", T, float,
                   double) {
    const auto solid_angle = [](T s) {
        return SphericalTriangle<T>({0, 0, 1}, {s, 0, 1}, {0, s, 1}).solid_angle();
    };
    const T least = std::sqrt(std::numeric_limits<T>::min());  // 10^-19 or 10^-154
    CHECK(double(solid_angle(8 * least) / (32 * square(least))) ==
          near(1, 4 * double(std::numeric_limits<T>::epsilon())));
    CHECK(solid_angle(least * std::numeric_limits<T>::epsilon()) == 0);
}

TEST_CASE(
    "next to a side that is nearly half a turn long, Van Oosterom and Strackee's sum cancels, half tangents "
    "don't") {
    const auto above_a_side = []<class T>(T height) {
        return Triangle<T>{{1, 0, height}, {-1, 0, height}, {T(0.125), 1, 1}};
    };
    for (const float height : {1e-3F, 1e-5F, 1e-7F}) {
        CAPTURE(height);
        const auto& [a, b, c] = above_a_side(height);
        const double exact    = double(solid_angle(above_a_side(static_cast<long double>(height))).value());
        CHECK(double(SphericalTriangle<float>(a, b, c).solid_angle()) == near(exact, 5e-7));
        const auto& [A, B, C] = above_a_side(double(height));
        CHECK(SphericalTriangle<double>(A, B, C).solid_angle() == near(exact, 5e-13));
        CHECK(std::abs(double(solid_angle(above_a_side(height)).value()) / exact - 1) >= 1e-5);
    }
}
