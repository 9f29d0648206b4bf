#pragma once
/// @file sample_sizes.hpp
/// Samples as bars: figure 9.1.

#include <fmt/format.h>

#include <cstdint>
#include <string>
#include <vector>

#include "course/chapter.hpp"
#include "first_integral.hpp"
#include "sampling/rng.hpp"

namespace sr {

/// A bar of a sum that approximates an integral: where the integrand is asked, and how wide its answer is taken to be.
struct Bar {
    double x;
    double width;
};

/// What the bars cover in all: of the axis, and under their tops.
struct BarSums {
    double widths = 0;
    double area   = 0;
};

[[nodiscard]] inline BarSums sums_of(const std::vector<Bar>& bars) {
    BarSums sums;
    for (const Bar& bar : bars) {
        sums.widths += bar.width;
        sums.area += growth(bar.x) * bar.width;
    }
    return sums;
}

/// The middles of n equal steps from 0 to 2.
[[nodiscard]] inline std::vector<Bar> steps(int n) {
    std::vector<Bar> bars;
    for (int i = 0; i < n; ++i) bars.push_back({2 * (i + 0.5) / n, 2.0 / n});
    return bars;
}

/// n samples, each as wide as (9.4) says.
template <class Density>
[[nodiscard]] std::vector<Bar> samples(const Density& p, std::uint64_t seed, int n) {
    Rng              rng{seed, 0, 0, 0};
    std::vector<Bar> bars;
    for (int i = 0; i < n; ++i) {
        const double x = p.sample(rng.uniform<double>());
        bars.push_back({x, 1 / (n * p.pdf(x))});
    }
    return bars;
}

/// One of the figure's pictures: e^x, and bars under it.
inline void draw_bars(course::Diagram diagram, double left, const std::string& name,
                      const std::vector<Bar>& bars, course::Ink ink) {
    using course::Point;
    const auto place = [=](double x, double y) { return Point{left + 1.7 * x, 0.45 * y}; };
    for (const auto& [x, width] : bars) {
        const double from = x - width / 2, to = x + width / 2, top = growth(x);
        diagram.polygon({place(from, 0), place(to, 0), place(to, top), place(from, top)},
                        {ink, course::Weight::thin}, 0.3);
    }
    std::vector<Point> curve;
    for (int i = 0; i <= 40; ++i) curve.push_back(place(i / 20.0, growth(i / 20.0)));
    diagram.line(curve);
    diagram.arrow(place(-0.15, 0), place(2.3, 0), {course::Ink::grey, course::Weight::thin});
    for (const Bar& bar : bars) diagram.point(place(bar.x, growth(bar.x)), {ink});
    for (const int x : {0, 1, 2})
        diagram.label(place(x, -0.5), fmt::format("{}", x), course::Anchor::centre, course::Ink::grey);
    const BarSums sums = sums_of(bars);
    diagram.label(place(1.15, 4.3), "$e^x$", course::Anchor::right);
    diagram.label(place(0, 7.2), name, course::Anchor::left, ink);
    diagram.label(place(1, -1.6), fmt::format("bars {:.2f}, widths {:.2f}", sums.area, sums.widths),
                  course::Anchor::centre);
}

}  // namespace sr
