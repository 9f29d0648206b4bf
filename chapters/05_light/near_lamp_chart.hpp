#pragma once
/// @file near_lamp_chart.hpp
/// Figure 5.21: a lamp that comes near.

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <tuple>

#include "course/chapter.hpp"
#include "near_lamp.hpp"

namespace sr {

/// The standard deviation of one estimate by area over its mean, exactly.
[[nodiscard]] inline double near_lamp_deviation(double h) {
    const double pi     = std::numbers::pi;
    const double mean   = pi / (1 + h * h);
    const double second = square(pi) * std::pow(h, 4) * (std::pow(h, -6) - std::pow(h * h + 1, -3)) / 3;
    return std::sqrt(second - square(mean)) / mean;
}

inline void chart_near_lamp(course::Chapter& chapter) {
    auto chart = chapter.chart(
        "near_lamp", "One sample of a disk that comes near",
        {.x = "height of the disk [radii]", .y = "standard deviation / mean", .log = course::axis::xy});
    const auto deviation = [](double h, NearLamp way) {
        const auto of = sample_near_lamp(h, way, 20'000);
        return std::sqrt(of.variance()) / of.mean();
    };
    for (int i = -12; i <= 4; ++i) {
        const double h = std::pow(10.0, i / 4.0);
        chart.add("area", h, near_lamp_deviation(h));
        chart.add("solid angle", h, deviation(h, NearLamp::solid_angle));
    }
    chart.caption(
        "By area in closed form, by solid angle from 20 000 samples; by projected solid angle it is 0.");
    for (const auto& [h, expected, digit] :
         {std::tuple{1.0, 0.41, 0.01}, {0.1, 5.745, 0.001}, {0.01, 58.0, 1.0}})
        chapter.claim(
            fmt::format("5.8 by area, a disk at the height {}: deviation of one sample over the mean", h),
            {.expected = expected, .measured = near_lamp_deviation(h), .tolerance = digit / 2});
    chapter.claim_at_most("5.8 by solid angle, at the height 0.01: deviation over the mean",
                          deviation(0.01, NearLamp::solid_angle), 0.58);
    chapter.claim(
        "5.8 by projected solid angle, at the height 0.01: deviation over the mean",
        {.expected = 0, .measured = deviation(0.01, NearLamp::projected_solid_angle), .tolerance = 1e-12});
}

}  // namespace sr
