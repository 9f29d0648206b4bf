#pragma once
/// @file overhead_chart.hpp
/// Section 9.5: a lamp that comes near, and four densities.

#include <cmath>
#include <cstdint>
#include <string>

#include "course/claims.hpp"
#include "math/extremes.hpp"
#include "moments.hpp"
#include "overhead_lamp.hpp"

namespace sr {

/// The deviation of one sample that is seen; of estimates that take two, theirs times the root of 2.
/// @param samples  that one draw takes
/// @param draw     (Rng&) -> an estimate of 1
template <class Draw>
[[nodiscard]] Estimate deviation_seen(std::uint64_t stream, int threads, int samples, const Draw& draw) {
    const auto   variance  = moments_of(stream, draw, threads).variance;
    const double deviation = std::sqrt(samples * variance.value);
    return {deviation, samples * variance.error / (2 * deviation)};
}

[[nodiscard]] inline Estimate deviation_by_both(const OverheadLamp& lamp, Heuristic heuristic,
                                                std::uint64_t stream, int threads) {
    return deviation_seen(stream, threads, 2, [&](Rng& rng) {
        const auto u = draw_pair(rng), v = draw_pair(rng);
        return lamp.by_both(heuristic, u, v);
    });
}

/// What the text says of it.
inline void claim_overhead_lamp(course::Chapter& chapter) {
    const course::Claims claim{chapter, "9.5"};
    const int            threads = chapter.options().threads;
    const OverheadLamp   near(0.01), far(10);
    claim("a disk at 0.01: deviation by area", 57.7, near.deviation_by_area(), 0.05);
    claim("a disk at 0.01: by solid angle", 0.566, near.deviation_by_solid_angle(), 5e-4);
    const Estimate by_cosine =
        deviation_seen(404, threads, 1, [&](Rng& rng) { return near.by_cosine(draw_pair(rng)); });
    claim("a disk at 0.01: by the cosine, measured", 0.0101, by_cosine.value, 5e-5);
    claim("its standard error", 0.0012, by_cosine.error, 5e-5);
    claim("a disk at 10: by area", 0.00574, far.deviation_by_area(), 5e-6);
    claim("a disk at 10: by solid angle", 0.00144, far.deviation_by_solid_angle(), 5e-6);
    claim("a disk at 10: by both, balance", 0.14,
          deviation_by_both(far, Heuristic::balance, 401, threads).value, 5e-3);
    claim("a disk at 10: by both, power", 0.0082,
          deviation_by_both(far, Heuristic::power, 402, threads).value, 5e-5);
    claim("a disk at 0.01: by both, balance", 0.17,
          deviation_by_both(near, Heuristic::balance, 403, threads).value, 5e-3);
}

/// Figure 9.13.
inline void chart_overhead_lamp(course::Chapter& chapter) {
    auto chart = chapter.chart(
        "overhead_lamp", "One sample of a disk overhead",
        course::with_error(
            {.x = "height of the disk [radii]", .y = "standard deviation / mean", .log = course::axis::xy}));
    for (int i = -20; i <= 10; ++i) {
        const double       h = std::pow(10, i / 10.0);
        const OverheadLamp lamp(h);
        chart.add("area", h, Estimate{lamp.deviation_by_area()});
        chart.add("cosine", h, Estimate{lamp.deviation_by_cosine()});
        chart.add("solid angle", h, Estimate{lamp.deviation_by_solid_angle()});
    }
    const int     threads = chapter.options().threads;
    double        worst   = 0;
    std::uint64_t stream  = 2000;  // each height has ten of its own
    for (int i = -8; i <= 4; ++i, stream += 10) {
        const double       h = std::pow(10, i / 4.0);
        const OverheadLamp lamp(h);
        const auto         seen = [&](std::uint64_t of, auto way) {
            return deviation_seen(stream + of, threads, 1,
                                          [&](Rng& rng) { return (lamp.*way)(draw_pair(rng)); });
        };
        if (i >= -4) chart.add("measured", h, seen(1, &OverheadLamp::by_area));
        chart.add("measured", h, seen(2, &OverheadLamp::by_cosine));
        chart.add("measured", h, seen(3, &OverheadLamp::by_solid_angle));
        const Estimate balance = deviation_by_both(lamp, Heuristic::balance, stream + 4, threads);
        const Estimate power   = deviation_by_both(lamp, Heuristic::power, stream + 5, threads);
        chart.add("area and cosine, balance", h, balance);
        chart.add("area and cosine, power", h, power);
        worst = max_or_nan(worst, max_or_nan(balance.value, power.value));
    }
    for (const auto* way : {"area", "cosine", "solid angle"}) chart.as_line(way);
    chart.as_points("measured");
    chart.in_ink("measured", course::Ink::grey);
    chart.caption(
        "Lines of single densities are closed forms, those of two join what is measured: one pair's "
        "deviation, "
        "times the root of 2. Area is not measured below 0.1: too few samples are right overhead.");
    chapter.claim_at_most("9.5 a disk at any height of the figure: deviation by both", worst, 1);
}

}  // namespace sr
