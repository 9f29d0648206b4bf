#pragma once
/// @file light_sampling_claims.hpp
/// Section 10.2: a near lamp, a ball, and two lamps; by how they are drawn from.

#include <cmath>
#include <cstdint>
#include <string>
#include <tuple>

#include "course/claims.hpp"
#include "floor_under_ball.hpp"
#include "math/degrees.hpp"
#include "square_overhead.hpp"

namespace sr {

/// One direction to a square lamp from below its middle, by its area and by its solid angle.
inline void chart_near_lamp(course::Chapter& chapter) {
    auto chart = chapter.chart("near_lamp", "One direction to a square lamp overhead",
                               course::with_error({.x   = "height of the lamp [half its side]",
                                                   .y   = "standard deviation / mean",
                                                   .log = course::axis::xy}));
    for (int i = -20; i <= 10; ++i) {
        const double         h = std::pow(10, i / 10.0);
        const SquareOverhead lamp(h);
        chart.add("area", h, Estimate{lamp.deviation_by_area()});
        chart.add("solid angle", h, Estimate{lamp.deviation_by_solid_angle()});
    }
    const int threads = chapter.options().threads;
    for (int i = -8; i <= 4; ++i) {
        const double         h = std::pow(10, i / 4.0);
        const SquareOverhead lamp(h);
        if (i >= -4)  // below, too few points are overhead
            chart.add("measured", h, lamp.deviation_seen(TriangleSampling::area, 21, threads));
        chart.add("measured", h, lamp.deviation_seen(TriangleSampling::solid_angle, 22, threads));
    }
    for (const auto* name : {"area", "solid angle"}) chart.as_line(name);
    chart.as_points("measured");
    chart.in_ink("measured", course::Ink::grey);
    // three times the distance of the furthest corner from a triangle's middle, as Emitters does it
    chart.mark_x(std::sqrt(20 - 2.0 / 9), "by area from here");
    chart.caption("Lines are closed forms. Area is not measured below 0.1: too few points are overhead.");
}

/// What the text says of it.
inline void claim_near_lamp(course::Chapter& chapter) {
    const course::Claims claim{chapter, "10.2"};
    for (const auto& [h, name, area, digit, solid_angle, last] :
         {std::tuple{0.01, "0.01", 65.1, 0.1, 0.567, 0.001},
          {0.1, "0.1", 6.49, 0.01, 0.483, 0.001},
          {1.0, "1", 0.505, 0.001, 0.120, 0.001},
          {10.0, "10", 0.00835, 1e-5, 0.00209, 1e-5}}) {
        const SquareOverhead lamp(h);
        const auto           of = std::string("a square at ") + name + ": deviation by ";
        claim(of + "area", area, lamp.deviation_by_area(), digit / 2);
        claim(of + "solid angle", solid_angle, lamp.deviation_by_solid_angle(), last / 2);
    }
    // tolerances are four standard errors
    const int            threads = chapter.options().threads;
    const SquareOverhead one(1);
    const auto           area  = one.deviation_seen(TriangleSampling::area, 24, threads);
    const auto           solid = one.deviation_seen(TriangleSampling::solid_angle, 25, threads);
    claim("a square at 1: deviation by area, measured", 0.505, area.value, 4 * area.error);
    claim("a square at 1: deviation by solid angle, measured", 0.120, solid.value, 4 * solid.error);
    const auto near = SquareOverhead(0.1).deviation_seen(TriangleSampling::by_distance, 26, threads);
    const auto far  = SquareOverhead(10).deviation_seen(TriangleSampling::by_distance, 27, threads);
    claim("a square at 0.1: deviation by distance, measured", 0.483, near.value, 4 * near.error);
    claim("a square at 10: deviation by distance, measured", 0.00835, far.value, 4 * far.error);
}

/// The table of 9.2 again, by three strategies of the path tracer (row H4). Tolerances are four standard errors.
inline void claim_ball_lamp(course::Chapter& chapter) {
    const course::Claims claim{chapter, "10.2"};
    course::Rows         table{{"half-angle", "strategy", "variance", "measured", "standard error"}};
    const auto           row = [&](int degrees, const char* name, Strategy strategy, double exact) {
        const auto seen =
            FloorUnderBall(radians(double(degrees))).variance(strategy, 31, chapter.options().threads);
        table.add({degrees, name, exact, seen.value, seen.error});
        claim("a ball of " + std::to_string(degrees) + " degrees, " + name + ": variance", exact, seen.value,
                        4 * seen.error);
    };
    row(10, "blind", Strategy::blind, 0.5817);
    row(10, "BSDF", Strategy::bsdf, 0.2886);
    row(10, "light", Strategy::light, 1.753e-7);
    row(30, "blind", Strategy::blind, 3.995);
    row(30, "BSDF", Strategy::bsdf, 1.851);
    row(30, "light", Strategy::light, 1.060e-3);
    chapter.say(table);
}

/// Two small balls, of which a direction goes to one, chosen by power: the near one gives an irradiance of 9 with a
/// tenth of the power of both, the other 1. With the chance p of the near one the variance is 81 / p + 1 / (1 - p) -
/// 100 (row H21).
inline void claim_two_balls(course::Chapter& chapter) {
    constexpr double radius = 0.01, near = 2, far = 9 * near;  // of 9 times the power
    Scene            scene;
    scene.materials = {grey(0, 1), grey(0, 9)};
    scene.balls     = {{{{near, 0, near}, radius}, 0}, {{{-far, 0, far}, radius}, 1}};
    const Emitters emitters(scene);
    Rng            rng{41, 0, 0, 0};
    Running        E;
    for (int i = 0; i < 1 << 18; ++i) E.add(SquareOverhead::one(emitters, rng));
    const auto           deviation = [](double p) { return std::sqrt(81 / p + 1 / (1 - p) - 100) / 10; };
    // each number is one of two: their kurtosis says that a standard error is 0.0070
    const course::Claims claim{chapter, "10.2"};
    claim("two balls: deviation over the mean, chosen by power", 2.67, std::sqrt(E.variance()) / E.mean(),
          0.028);
    claim("two balls: deviation over the mean, chosen by a coin", 0.8, deviation(0.5), 0.05);
    claim("two balls: deviation over the mean, by power, by the formula", 2.67, deviation(0.1), 5e-3);
}

}  // namespace sr
