/// @file solid_angles.cpp
/// Small lamps and near ones, where the textbook loses them: rows S31, S32, S33, S34, S41 and S54. The textbook's forms
/// are those that chapter 5 charts.

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>
#include <tuple>

#include "../../chapters/05_light/near_lamp.hpp"
#include "../../chapters/05_light/small_lamps.hpp"
#include "../../chapters/05_light/textbook_solid_angles.hpp"
#include "catalogue.hpp"
#include "geometry/sphere.hpp"
#include "math/gauss_legendre.hpp"
#include "math/square.hpp"
#include "near.hpp"
#include "radiometry/polygon_solid_angle.hpp"
#include "radiometry/solid_angle.hpp"
#include "sampling/cone.hpp"
#include "sampling/hemisphere.hpp"

using namespace sr;
using test::near;
using test::within_factor_3;

namespace {

using std::numbers::pi;

template <class T>
double cured_sphere(double d) {
    return double(solid_angle(Sphere<T>{{0, 0, T(d)}, 1}).value());
}

}  // namespace

TEST_CASE(
    "S31: 2 pi (1 - cos) of a far sphere is 0 in float from 10^4 radii on, twice too large in double at "
    "10^8") {
    struct Row {
        double d, exact, textbook_float, textbook_double;
    };
    for (const auto& [d, exact, in_float, in_double] :
         {Row{10, 0.031494862, 0.03149, 0.0314949}, Row{1e3, 3.1415934e-6, 3.371e-6, 3.14159e-6},
          Row{1e4, 3.1415927e-8, 0, 3.14159e-8}, Row{1e7, 3.1415927e-14, 0, 3.13908e-14},
          Row{1e8, 3.1415927e-16, 0, 6.97574e-16}}) {
        CAPTURE(d);
        CHECK(std::abs(double(textbook_sphere_solid_angle(1.0F, float(d))) - in_float) <= 1e-3 * in_float);
        CHECK(textbook_sphere_solid_angle(1.0, d) == near(in_double, 1e-5));
        CHECK(cured_sphere<float>(d) == near(exact, 1e-6));
        CHECK(cured_sphere<double>(d) == near(exact, 1e-7));
    }
    // a lamp without a solid angle has no density to be drawn with; the cured one has
    CHECK(std::isinf(1 / textbook_sphere_solid_angle(1.0F, 1e4F)));
    CHECK(pdf_cone(Vec3{0, 0, 1}, 1e-8F).value == near(1e16 / pi, 1e-6));
}

TEST_CASE("S32: by its cosine, a small cone is drawn in a few rings, then in its middle only") {
    struct Row {
        float  s;
        int    distinct;  // as the catalogue counted them, of 200 000
        double spread;    // E[sin^2] / (s^2 / 2)
    };
    for (const auto& [s, distinct, spread] : {Row{1e-1F, 76347, 1.001}, Row{1e-2F, 840, 1},
                                              Row{1e-3F, 10, 1.073}, Row{3e-4F, 2, 1.32}, Row{1e-4F, 1, 0}}) {
        CAPTURE(s);
        const ConeDraws textbook =
            draw_cone(s, 200'000, [](Vec2 u, float sine) { return textbook_cone(u, sine); });
        const ConeDraws cured =
            draw_cone(s, 200'000, [](Vec2 u, float sine) { return sample_cone(u, sine); });
        CHECK(within_factor_3(textbook.distinct, distinct));
        CHECK(std::abs(textbook.spread - spread) <= 0.15 * spread);
        CHECK(cured.distinct > 190'000);
        CHECK(std::abs(cured.spread - 1) <= 5 * cured.spread_se);
    }
}

TEST_CASE(
    "S33: the spherical excess of a small triangle is rounding, Van Oosterom and Strackee's formula is not") {
    struct Row {
        double s, exact, girard_float, girard_double;
    };
    for (const auto& [s, exact, in_float, in_double] :
         {Row{1e-1, 0.004975144902, 0.00498, 0.00497514}, Row{1e-2, 4.999750015e-5, 5.01e-5, 4.99975e-5},
          Row{1e-3, 4.9999975e-7, 2.38e-7, 5e-7}, Row{1e-4, 4.999999975e-9, -2.38e-7, 5e-9},
          Row{1e-6, 5e-13, 0, 5.00044e-13}}) {
        CAPTURE(s);
        const auto   girard_in_float = [](float legs) { return girard_solid_angle(small_triangle(legs)); };
        // in float, what is left below 10^-2 is a few last digits of pi, and which ones is chance
        const double girard = double(girard_in_float(float(s)));
        if (s >= 1e-2)
            CHECK(girard == near(in_float, 0.05));
        else
            CHECK(std::abs(girard - exact) <= 1.5e-6);
        if (s <= 1e-3) CHECK(worst_relative_error(s, girard_in_float, exact_triangle) >= 0.2);
        if (s <= 1e-4) CHECK(std::abs(girard - exact) >= 0.5 * exact);
        CHECK(girard_solid_angle(small_triangle(s)) == near(in_double, 1e-2));
        CHECK(double(solid_angle(small_triangle(float(s))).value()) == near(exact, 5e-7));
        CHECK(solid_angle(small_triangle(s)).value() == near(exact, 1e-9));
    }
    // Nothing is special about the axis, or about atan2 alone: a . (b x c), as it is printed, loses the same digits.
    const Triangle<float>  aside{{0.6F, -0.5F, 0.7F}, {0.601F, -0.5003F, 0.7F}, {0.6002F, -0.499F, 0.7005F}};
    const Triangle<double> same{aside.a, aside.b, aside.c};
    const double           exact = solid_angle(same).value();
    CHECK(exact == near(std::abs(girard_solid_angle(same)), 1e-8));
    CHECK(double(solid_angle(aside).value()) == near(exact, 1e-6));
    CHECK(std::abs(double(std::abs(textbook_triangle_solid_angle(aside))) / exact - 1) >= 1e-4);
    CHECK(std::abs(girard_solid_angle(Triangle<double>{{0, 0, 1}, {1e-6, 0, 1}, {0, 1e-6, 1}}) - 5e-13) >=
          1e-17);
}

TEST_CASE(
    "S34: with atan for atan2, a triangle that fills nearly half of all directions has a negative solid "
    "angle") {
    const double           angle = 2 * pi / 3;
    const Triangle<double> wide{{10, 0, 0.1},
                                {10 * std::cos(angle), 10 * std::sin(angle), 0.1},
                                {10 * std::cos(2 * angle), 10 * std::sin(2 * angle), 0.1}};
    CHECK(textbook_triangle_solid_angle(wide) == near(-0.103907, 1e-5));
    CHECK(solid_angle(wide).value() == near(6.179278, 1e-6));
}

TEST_CASE("S41: a random number of exactly 1 gives a direction in the horizon whose weight is 0 / 0") {
    const Vec3  level  = sample_cosine_hemisphere(Vec2{1, 0});
    const float pdf    = level.z / std::numbers::pi_v<float>;
    const float albedo = 0.5F, f = albedo / std::numbers::pi_v<float>;
    CHECK(level.z == 0);
    CHECK(std::isnan(f * level.z / pdf));
    CHECK(std::isinf(-std::log(1 - 1.0F)));
    CHECK(std::isinf(std::sqrt(-2 * std::log(0.0F))));
    // The generator's largest number is 1 - 2^-24, and the lowest direction has a weight: the albedo.
    const Vec3 lowest = sample_cosine_hemisphere(Vec2{1 - 0x1p-24F, 0});
    CHECK(lowest.z >= 0x1p-12F);
    CHECK(f * lowest.z / float(pdf_cosine_hemisphere(lowest).value) == near(0.5, 1e-6));
    CHECK(std::isfinite(-std::log(1 - (1 - 0x1p-24F))));
    CHECK(sample_cone(Vec2{1 - 0x1p-24F, 0}, 1.0F).z > 0);
}

TEST_CASE(
    "S54, H5: a disk sampled by area is the noisier the nearer it is; by solid angle hardly, by the "
    "projected not") {
    struct Row {
        double h, deviation;
    };
    for (const auto& [h, deviation] : {Row{1, 0.408}, Row{0.1, 5.74}, Row{0.01, 57.7}, Row{0.001, 577}}) {
        CAPTURE(h);
        // H5 in closed form
        const double second = square(pi) * std::pow(h, 4) * (std::pow(h, -6) - std::pow(h * h + 1, -3)) / 3;
        const double mean   = pi / (1 + h * h);
        CHECK(std::sqrt(second - square(mean)) / mean == near(deviation, 2e-3));
        // and of the estimates themselves: they are rare and bright where u = v^8 is small
        double sum = 0, squares = 0;
        for (const auto& [v, weight] : gauss_legendre(200, 0, 1)) {
            const double estimate = near_lamp_estimate(h, NearLamp::area, {std::pow(v, 8), 0});
            sum += weight * 8 * std::pow(v, 7) * estimate;
            squares += weight * 8 * std::pow(v, 7) * square(estimate);
        }
        CHECK(sum == near(mean, 1e-9));
        CHECK(std::sqrt(squares - square(sum)) / sum == near(deviation, 2e-3));
        const auto directions = sample_near_lamp(h, NearLamp::solid_angle, 400'000);
        CHECK(std::abs(directions.mean() - mean) <= 5 * directions.standard_error());
        CHECK(std::sqrt(directions.variance()) / mean <= 1 / std::sqrt(3.0));
        const auto projected = sample_near_lamp(h, NearLamp::projected_solid_angle, 1000);
        CHECK(projected.mean() == near(mean, 1e-12));
        CHECK(std::sqrt(projected.variance()) <= 1e-12);
    }
    // Directions uniform in the projected solid angle, each counted as 1 / pdf, add up to the solid angle; drawn from a
    // wrong cone or with its density they do not.
    const auto solid_angle_by = [](double drawn, double weighed) {
        Running of;
        Rng     rng{2, 0, 0, 0};
        for (int i = 0; i < 100'000; ++i) {
            const double x = rng.uniform<double>();
            const auto   w = sample_projected_cone({x, rng.uniform<double>()}, drawn);
            of.add(1 / pdf_projected_cone(w, weighed).value);
        }
        return of;
    };
    const auto from_exact = [](const Running& of) {
        return std::abs(of.mean() - 2 * pi * cone_height(0.9)) / of.standard_error();
    };
    CHECK(from_exact(solid_angle_by(0.9, 0.9)) <= 5);
    CHECK(from_exact(solid_angle_by(0.88, 0.9)) > 10);
    CHECK(from_exact(solid_angle_by(0.9, 0.92)) > 10);
    for (const auto& [h, mean, variance] : {std::tuple{1.0, 1.5707963267948966, 0.41123351671205661},
                                            {0.5, 2.5132741228718346, 6.7376499378103355},
                                            {0.1, 3.1104877758314785, 319.31135985468837}}) {
        const auto area = sample_near_lamp(h, NearLamp::area, 400'000);
        CHECK(std::abs(area.mean() - mean) <= 5 * area.standard_error());
        CHECK(area.variance() == near(variance, h < 0.2 ? 0.1 : 0.02));
    }
}
