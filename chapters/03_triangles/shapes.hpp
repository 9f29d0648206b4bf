#pragma once
/// @file shapes.hpp
/// Charts of what becomes of triangles that are small, thin, or far from the origin.

#include <fmt/format.h>

#include <cmath>
#include <string>
#include <vector>

#include "attack.hpp"
#include "course/chapter.hpp"
#include "geometry/area_of_sides.hpp"
#include "geometry/triangle.hpp"
#include "statistics/running.hpp"
#include "textbook.hpp"

namespace sr {

/// A triangle of points in [0, 1]^3, neither thin nor seen edge-on, and a unit ray at a point of it.
struct Shot {
    Triangle<double> triangle;
    Ray<double>      ray;
    Vector2<double>  uv;  ///< of the point
};

[[nodiscard]] inline Shot random_shot(int number) {
    Rng        rng{6, 0, 0, number};
    const auto point = [&] { return 0.5 + 0.5 * in_cube(rng); };
    for (;;) {
        const auto   a = point(), b = point(), c = point(), origin = 3.0 * point() - 1.0;
        const double b1 = rng.uniform<double>(), b2 = rng.uniform<double>() * (1 - b1);
        const auto   direction = normalize(a + b1 * (b - a) + b2 * (c - a) - origin);
        const auto   n         = cross(b - a, c - a);
        if (length(n) > 0.1 && std::abs(dot(n, direction)) > 0.1 * length(n))
            return {{a, b, c}, {origin, direction}, {b1, b2}};
    }
}

/// The share [%] of so many shots that miss.
[[nodiscard]] double percent_missed(const std::vector<Shot>& shots, const auto& hits) {
    int missed = 0;
    for (const auto& shot : shots) missed += hits(shot) ? 0 : 1;
    return 100.0 * missed / double(shots.size());
}

[[nodiscard]] inline std::vector<Shot> random_shots(int count) {
    std::vector<Shot> shots;
    for (int i = 0; i < count; ++i) shots.push_back(random_shot(i));
    return shots;
}

/// How a shot is brought into T: scaled and moved away; and if its triangle belongs to a mesh with coordinates of its
/// own, moved there before it is rounded. The ray's direction stays.
struct Displacement {
    double scale = 1, distance = 0;
    bool   local = false;

    [[nodiscard]] Vector3<double> operator()(Vector3<double> p) const {
        return (scale * p + distance) - (local ? distance : 0);
    }
};

template <std::floating_point T>
[[nodiscard]] bool is_hit(const Shot& shot, Displacement place, const auto& intersect) {
    const auto in         = [&](Vector3<double> p) { return Vector3<T>(place(p)); };
    const auto& [a, b, c] = shot.triangle;
    const Ray<T> ray{in(shot.ray.origin), Vector3<T>(shot.ray.direction)};
    return intersect(Triangle<T>{in(a), in(b), in(c)}, ray).has_value();
}

inline constexpr auto watertight = []<class T>(const Triangle<T>& triangle, const Ray<T>& ray) {
    return TriangleRay<T>(ray).intersect(triangle, in_front<T>);
};

/// So many rays at triangles of each size, and at each distance.
inline constexpr int small_triangles = 4000, far_triangles = 20'000;

/// Figure 3.6: which triangles an absolute epsilon loses.
[[nodiscard]] inline course::Chart chart_small_triangles(course::Chapter& chapter) {
    auto chart = chapter.chart(
        "small_triangles", "Rays at triangles of all sizes, in float",
        course::with_error(
            {.x = "size of the triangles", .y = "triangles missed [%]", .log = course::axis::x}));
    const auto shots = random_shots(small_triangles);
    const auto add   = [&](const std::string& name, double size, const auto& intersect) {
        const double missed = percent_missed(
              shots, [&](const Shot& s) { return is_hit<float>(s, {.scale = size}, intersect); });
        chart.add(name, size, missed, {standard_error(missed, shots.size())});
        return missed;
    };
    const auto size_of = [](int fifth) { return std::pow(10.0, fifth / 5.0); };
    for (const auto& [name, epsilon] : {std::pair{"epsilon $10^{-3}$", 1e-3F},
                                        {"epsilon $10^{-6}$", 1e-6F},
                                        {"epsilon $10^{-8}$", 1e-8F}}) {
        const auto textbook = [&](const Triangle<float>& triangle, const Ray<float>& ray) {
            return textbook::intersect(triangle, ray, in_front<float>, epsilon);
        };
        for (int fifth = -30; fifth <= 2 && add(name, size_of(fifth), textbook) > 0; ++fifth) {
        }
    }
    for (int fifth = -30; fifth <= 2; ++fifth) add("no epsilon", size_of(fifth), watertight);
    chart.caption(
        "A determinant has the unit of an area: comparing it with a number makes small triangles vanish. A "
        "curve "
        "ends where nothing is missed any more.");
    return chart;
}

/// Figure 3.7: the area of a needle from its sides: the mean relative error of isosceles ones.
[[nodiscard]] inline course::Chart chart_needles(course::Chapter& chapter) {
    auto chart = chapter.chart(
        "needles", "Area of a needle from its three sides, in float",
        course::with_error(
            {.x = "short side / long side", .y = "relative error of the area", .log = course::axis::xy}));
    for (int quarters = 0; quarters >= -28; --quarters) {
        const double ratio = std::pow(10.0, quarters / 4.0);
        Running      heron, kahan;
        for (int i = 0; i < 500; ++i) {
            Rng          rng{7, 0, 0, i};
            const float  a = 1 + rng.uniform(), c = a * float(ratio) * (1 - 0.2F * rng.uniform());
            // c/2 sqrt(a^2 - c^2/4), in double
            const double right = c / 2.0 * std::sqrt((a - c / 2.0) * (a + c / 2.0));
            heron.add(std::abs(textbook::heron(a, a, c) / right - 1));
            kahan.add(std::abs(area_of_sides(a, a, c) / right - 1));
        }
        chart.add("Heron", ratio, heron.mean(), {heron.standard_error()});
        chart.add("Kahan", ratio, kahan.mean(), {kahan.standard_error()});
    }
    chart.caption(
        "Heron's formula subtracts each side from a sum that has been rounded; Kahan's subtracts sides from "
        "sides.");
    return chart;
}

/// Figure 3.8: rays at random points of triangles that stand ever farther from the origin.
[[nodiscard]] inline course::Chart chart_far_away(course::Chapter& chapter) {
    auto       chart = chapter.chart("far_away", "Triangles of size 1 far from the origin",
                                     course::with_error({.x   = "distance [sizes of the triangle]",
                                                         .y   = "rays that miss their triangle [%]",
                                                         .log = course::axis::xy}));
    const auto shots = random_shots(far_triangles);
    for (int exponent = 0; exponent <= 28; ++exponent) {
        const double distance = std::pow(10.0, exponent / 4.0);
        const auto   add      = [&]<class T>(T, const std::string& name, bool local) {
            const double missed = percent_missed(shots, [&](const Shot& s) {
                return is_hit<T>(s, {.distance = distance, .local = local}, watertight);
            });
            chart.add(name, distance, missed, {standard_error(missed, shots.size())});
        };
        if (exponent % 2 == 0) {
            add(0.0F, "float, world", false);
            add(0.0F, "float, local", true);
        } else {  // in turns: both are at 0, and neither hides the other
            add(0.0, "double, world", false);
        }
    }
    chart.caption(
        "What the watertight test is given has been rounded before it begins: in local coordinates where "
        "numbers are fine, and nothing is lost.");
    return chart;
}

}  // namespace sr
