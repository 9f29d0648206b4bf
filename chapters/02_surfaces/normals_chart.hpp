#pragma once
/// @file normals_chart.hpp
/// The charts of section 2.6: how far normals are off, derived by hand, by dual numbers, and by differences over h; and
/// how long each takes.

#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <string>
#include <vector>

#include "course/chapter.hpp"
#include "differences.hpp"
#include "gallery.hpp"
#include "geometry/implicit_normal.hpp"
#include "math/angle.hpp"
#include "math/degrees.hpp"
#include "sampling/rng.hpp"
#include "statistics/estimate.hpp"
#include "statistics/running.hpp"

namespace sr {

/// A point of the torus; not a uniform one.
[[nodiscard]] inline Vector3<double> random_point_of_torus(Rng& rng) {
    const double phi       = 2 * std::numbers::pi * rng.uniform<double>();
    const double theta     = 2 * std::numbers::pi * rng.uniform<double>();
    const double from_axis = shown_torus<double>.ring + shown_torus<double>.tube * std::cos(theta);
    return {from_axis * std::cos(phi), from_axis * std::sin(phi), shown_torus<double>.tube * std::sin(theta)};
}

/// The gradient of (2.10), derived by hand.
template <std::floating_point T>
[[nodiscard]] Vector3<T> gradient_by_hand(Vector3<T> p) {
    const T R = shown_torus<T>.ring, r = shown_torus<T>.tube;
    return 4 * (dot(p, p) + R * R - r * r) * p - 8 * R * R * Vector3<T>{p.x, p.y, 0};
}

inline constexpr int normals_counted = 4096;

/// Mean angle [deg] between the torus' normals and gradients that somebody computes, at so many of its points.
/// @param gradient_at  (Vector3<T>) -> Vector3<T>
template <std::floating_point T, class Gradient>
[[nodiscard]] Estimate mean_angle(const Gradient& gradient_at) {
    Rng     rng{4, 0, 0, 0};
    Running mean;
    for (int i = 0; i < normals_counted; ++i) {
        const Vector3<T> p(random_point_of_torus(rng));
        const auto       n = unit(Vector3<double>(gradient_at(p)));
        if (!n) return {std::nan(""), std::nan("")};  // differences that are all 0
        const auto truth = normalize(gradient_by_hand(Vector3<long double>(p)));
        mean.add(degrees(angle_between(*n, Vector3<double>(truth))));
    }
    return {mean.mean(), mean.standard_error()};
}

template <std::floating_point T>
[[nodiscard]] Estimate mean_angle_of_differences(double h) {
    return mean_angle<T>([&](Vector3<T> p) { return gradient_by_differences(shown_torus<T>, p, T(h)); });
}

template <std::floating_point T>
[[nodiscard]] Estimate mean_angle_of_duals() {
    return mean_angle<T>([&](Vector3<T> p) { return gradient(shown_torus<T>, p); });
}

/// 10^(i / 2)
[[nodiscard]] inline double half_decade(int i) {
    return std::pow(10.0, i / 2.0);
}

[[nodiscard]] inline course::Chart chart_normals(course::Chapter& chapter) {
    auto       chart       = chapter.chart("normals", "Normals of a torus of radii 2 and 0.5",
                                           course::with_error({.x   = "$h$ of the differences [length]",
                                                               .y   = "mean angle to the true normal [deg]",
                                                               .log = course::axis::xy}));
    const auto duals_float = mean_angle_of_duals<float>(), duals_double = mean_angle_of_duals<double>();
    const auto by_hand = mean_angle<float>(gradient_by_hand<float>);
    for (int i = -24; i <= -2; ++i) {
        const double h        = half_decade(i);
        const auto   in_float = mean_angle_of_differences<float>(h);
        if (in_float.value > 0)  // not where they are 0, and the angle NaN
            chart.add("differences, float", h, in_float);
        chart.add("differences, double", h, mean_angle_of_differences<double>(h));
        chart.add("dual numbers, float", h, duals_float);
        chart.add("dual numbers, double", h, duals_double);
        chart.add("by hand, float", h, by_hand);
    }
    chart.mark_x(std::cbrt(double(std::numeric_limits<float>::epsilon())), "$\\varepsilon^{1/3}$, float");
    chart.mark_x(std::cbrt(std::numeric_limits<double>::epsilon()), "$\\varepsilon^{1/3}$, double");
    chart.caption(
        "Too large an $h$ sees the surface bend, too small a one sees rounding; dual numbers have no $h$.");
    return chart;
}

/// A way to a gradient in float, at one effort: the h of differences, or 0.
struct Differentiation {
    std::string name;
    double      effort;
    std::function<Vec3(const std::vector<Vec3>&)>
             sum;  ///< of the gradients at all points: work for the clock
    Estimate angle;
};

/// @param gradient_at  (Vec3) -> Vec3, compiled into the loop over the points as a renderer has it
template <class Gradient>
[[nodiscard]] Differentiation differentiation(const std::string& name, double effort,
                                              const Gradient& gradient_at) {
    const auto sum = [=](const std::vector<Vec3>& points) {
        Vec3 all{0, 0, 0};
        for (const Vec3& p : points) all = all + gradient_at(p);
        return all;
    };
    return {name, effort, sum, mean_angle<float>(gradient_at)};
}

/// Angle against time for a gradient, in float.
inline void chart_normals_speed(course::Chapter& chapter) {
    std::vector<Differentiation> ways{
        differentiation("by hand", 0, [](const Vec3& p) { return gradient_by_hand(p); }),
        differentiation("dual numbers", 0, [](const Vec3& p) { return gradient(shown_torus<float>, p); })};
    for (const float h : {0.1F, 0.01F, 0.001F, 0.0001F})
        ways.push_back(differentiation("differences", double(h), [=](const Vec3& p) {
            return gradient_by_differences(shown_torus<float>, p, h);
        }));

    Rng               rng{5, 0, 0, 0};
    std::vector<Vec3> points;
    for (int i = 0; i < normals_counted; ++i) points.emplace_back(random_point_of_torus(rng));
    Vec3                      sum{0, 0, 0};  // looked at below: what nobody needs is optimised away
    std::vector<course::Work> work;
    for (const auto& way : ways) work.push_back({way.name, [&] { sum = sum + way.sum(points); }});
    const bool draft   = chapter.options().quality == course::Quality::draft;
    const auto timings = course::measure(work, draft ? 3 : 101);
    if (!(length(sum) > 0)) throw std::logic_error("all gradients of a torus are 0");

    auto columns = course::speed_accuracy({"ns_per_normal"});
    columns.x    = "ns_per_normal";
    auto chart   = chapter.chart("normals_speed", "The same normals in float, against time",
                                 {.x       = "time for a gradient, one thread [ns]",
                                  .y       = "mean angle to the true normal [deg]",
                                  .log     = course::axis::y,
                                  .columns = columns});
    for (std::size_t i = 0; i < ways.size(); ++i) {
        const double seconds = timings[i].seconds / double(points.size());
        chart.row(
            {ways[i].name, ways[i].effort, seconds, ways[i].angle.value, ways[i].angle.error, 1e9 * seconds});
    }
    chart.caption("Differences over 0.1, 0.01, 0.001 and 0.0001: all cost the same, and none is right.");
}

}  // namespace sr
