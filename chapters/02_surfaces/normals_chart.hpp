#pragma once
/// @file normals_chart.hpp
/// The chart of section 2.6: how far normals are off, by differences over h and by dual numbers.

#include <cmath>
#include <limits>
#include <numbers>
#include <string>

#include "course/chapter.hpp"
#include "differences.hpp"
#include "gallery.hpp"
#include "geometry/implicit_normal.hpp"
#include "math/angle.hpp"
#include "math/degrees.hpp"
#include "sampling/rng.hpp"
#include "statistics/running.hpp"

namespace sr {

/// A point of the torus; not a uniform one.
[[nodiscard]] inline Vector3<double> random_point_of_torus(Rng& rng) {
    const double phi       = 2 * std::numbers::pi * rng.uniform<double>();
    const double theta     = 2 * std::numbers::pi * rng.uniform<double>();
    const double from_axis = shown_torus<double>.ring + shown_torus<double>.tube * std::cos(theta);
    return {from_axis * std::cos(phi), from_axis * std::sin(phi), shown_torus<double>.tube * std::sin(theta)};
}

/// The gradient (2.10) derived by hand, in long double.
[[nodiscard]] inline Vector3<double> torus_normal_by_hand(Vector3<double> at) {
    using Long = long double;
    const Vector3<Long> p(at);
    const Long          R = shown_torus<Long>.ring, r = shown_torus<Long>.tube;
    const Long          sum = dot(p, p) + R * R - r * r;
    return normalize(Long(4) * sum * p - Long(8) * R * R * Vector3<Long>{p.x, p.y, 0});
}

/// Mean angle [deg] between the torus' normals and gradients that somebody computes, at 4096 of its points.
/// @param gradient_at  (Vector3<T>) -> Vector3<T>
template <std::floating_point T, class Gradient>
[[nodiscard]] double mean_angle(const Gradient& gradient_at) {
    Rng     rng{4, 0, 0, 0};
    Running mean;
    for (int i = 0; i < 4096; ++i) {
        const Vector3<T> p(random_point_of_torus(rng));
        const auto       n = unit(Vector3<double>(gradient_at(p)));
        if (!n) return std::nan("");  // differences that are all 0
        mean.add(degrees(angle_between(*n, torus_normal_by_hand(Vector3<double>(p)))));
    }
    return mean.mean();
}

template <std::floating_point T>
[[nodiscard]] double mean_angle_of_differences(double h) {
    return mean_angle<T>([&](Vector3<T> p) { return gradient_by_differences(shown_torus<T>, p, T(h)); });
}

template <std::floating_point T>
[[nodiscard]] double mean_angle_of_duals() {
    return mean_angle<T>([&](Vector3<T> p) { return gradient(shown_torus<T>, p); });
}

/// 10^(i / 2)
[[nodiscard]] inline double half_decade(int i) {
    return std::pow(10.0, i / 2.0);
}

[[nodiscard]] inline course::Chart chart_normals(course::Chapter& chapter) {
    auto         chart       = chapter.chart("normals", "Normals of a torus of radii 2 and 0.5",
                                             {.x   = "$h$ of the differences [length]",
                                              .y   = "mean angle to the true normal [deg]",
                                              .log = course::axis::xy});
    const double duals_float = mean_angle_of_duals<float>(), duals_double = mean_angle_of_duals<double>();
    for (int i = -24; i <= -2; ++i) {
        const double h        = half_decade(i);
        const double in_float = mean_angle_of_differences<float>(h);
        if (in_float > 0)
            chart.add("differences, float", h, in_float);  // not where they are 0, and the angle NaN
        chart.add("differences, double", h, mean_angle_of_differences<double>(h));
        chart.add("dual numbers, float", h, duals_float);
        chart.add("dual numbers, double", h, duals_double);
    }
    chart.mark_x(std::cbrt(double(std::numeric_limits<float>::epsilon())), "$\\varepsilon^{1/3}$, float");
    chart.mark_x(std::cbrt(std::numeric_limits<double>::epsilon()), "$\\varepsilon^{1/3}$, double");
    chart.caption(
        "Too large an $h$ sees the surface bend, too small a one sees rounding; dual numbers have no $h$.");
    return chart;
}

}  // namespace sr
