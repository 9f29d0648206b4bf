/// @file implicit_normals.cpp
/// Where a gradient loses its digits, or is 0: rows S21 and S22.

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "../../chapters/02_surfaces/differences.hpp"
#include "../../chapters/02_surfaces/squared_sphere.hpp"
#include "catalogue.hpp"
#include "geometry/implicit_ellipsoid.hpp"
#include "geometry/implicit_normal.hpp"
#include "math/angle.hpp"
#include "math/degrees.hpp"
#include "sampling/rng.hpp"
#include "statistics/running.hpp"

using namespace sr;

namespace {

/// A uniform point of the unit sphere.
Vector3<double> on_sphere(Rng& rng) {
    const double z = 2 * rng.uniform<double>() - 1, phi = 6.283185307179586 * rng.uniform<double>();
    const double r = std::sqrt(1 - z * z);
    return {r * std::cos(phi), r * std::sin(phi), z};
}

/// Mean angle between p, which is the normal at p, and a normal that is computed there [deg].
template <class T, class Normal>
double mean_error(const Normal& normal_at) {
    Rng     rng{21, 0, 0, 0};
    Running error;
    for (int i = 0; i < 20'000; ++i) {
        const Vector3<T> p(on_sphere(rng));
        error.add(
            degrees(angle_between(normalize(Vector3<double>(normal_at(p))), normalize(Vector3<double>(p)))));
    }
    return error.mean();
}

template <class T>
double error_of_differences(T h) {
    const Ellipsoid<T> sphere{{1, 1, 1}};
    return mean_error<T>([&](Vector3<T> p) { return gradient_by_differences(sphere, p, h); });
}

template <class T>
double error_of_duals() {
    const Ellipsoid<T> sphere{{1, 1, 1}};
    return mean_error<T>([&](Vector3<T> p) { return normal(sphere, p, -p); });
}

struct Cone {
    template <class Number>
    auto f(const Number& x, const Number& y, const Number& z) const {
        return square(x) + square(y) - square(z);
    }
};

}  // namespace

TEST_CASE("S21: differences over h in float lose the normal as h shrinks, dual numbers never") {
    // The difference of two values of about eps in size, over 2 h: eps / h, up to a few units.
    for (const auto& [h, catalogued] :
         {std::pair{1e-4F, 0.0081}, {1e-5F, 0.081}, {1e-6F, 0.79}, {1e-7F, 8.4}}) {
        CAPTURE(h);
        CHECK(test::within_factor_3(error_of_differences(h), catalogued));
    }
    // The catalogue's 0.003 degrees for wider h are its angle's, acos of a scalar product, and not the differences':
    // f is quadratic, and has no third derivative that would bend away.
    for (const float h : {1e-1F, 1e-2F, 1e-3F}) CHECK(error_of_differences(h) <= 0.0034 / 3);
    // 1e-8 does not change a coordinate near 1: differences of equal values have no direction.
    int undefined = 0;
    Rng rng{22, 0, 0, 0};
    for (int i = 0; i < 1000; ++i) {
        const auto g = gradient_by_differences(Ellipsoid<float>{{1, 1, 1}}, Vec3(on_sphere(rng)), 1e-8F);
        undefined += length(g) > 0 ? 0 : 1;
    }
    CHECK(undefined > 900);

    CHECK(error_of_duals<float>() <= 1e-5);
    CHECK(error_of_duals<double>() <= 1e-13);
    for (const double h : {1e-2, 1e-4, 1e-6}) CHECK(error_of_differences(h) <= 1e-7);
}

TEST_CASE("S22: where the gradient is 0 the textbook's normal is NaN, and ours faces the viewer") {
    const Vector3<double> d{0, 0.6, -0.8}, apex{0, 0, 0};
    const auto            zero = gradient(Cone{}, apex);
    CHECK(zero == Vector3<double>(0, 0, 0));
    CHECK(std::isnan(normalize(zero).x));
    CHECK(normal(Cone{}, apex, d) == -d);
    CHECK(length(normal(Cone{}, {3, 0, 3}, d) - Vector3<double>{std::sqrt(0.5), 0, -std::sqrt(0.5)}) <=
          1e-15);

    // On a squared equation's surface the gradient is 0 wherever p is exact, and its sign is rounding's elsewhere.
    const Vector3<double> pole{0, 0, 1};
    CHECK(std::isnan(normalize(gradient(SquaredSphere{}, pole)).x));
    CHECK(normal(SquaredSphere{}, pole, d) == -d);
    CHECK(normal(Ellipsoid<double>{{1, 1, 1}}, pole, d) == pole);
    int inwards = 0;
    Rng rng{23, 0, 0, 0};
    for (int i = 0; i < 1000; ++i) {
        const auto p = on_sphere(rng);
        inwards += dot(normal(SquaredSphere{}, p, -p), p) < 0 ? 1 : 0;
        CHECK(dot(normal(Ellipsoid<double>{{1, 1, 1}}, p, -p), p) > 0.999);
    }
    // Of a million such points, 69.2 % have |p|^2 = 1 as rounded, and no gradient; 20.5 % are inside.
    CHECK(test::within_factor_3(inwards, 205));
}
