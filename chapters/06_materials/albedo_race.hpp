#pragma once
/// @file albedo_race.hpp
/// Section 6.7: albedos of lobes, by quadrature and by drawing directions; their error against time.

#include <cmath>
#include <functional>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include "course/chapter.hpp"
#include "material/dielectric.hpp"
#include "material/diffuse.hpp"
#include "material/phong.hpp"
#include "material/phong_albedo.hpp"
#include "reflected.hpp"
#include "sampling/hemisphere.hpp"
#include "sampling/rng.hpp"
#include "statistics/estimate.hpp"
#include "statistics/running.hpp"
#include "statistics/slope.hpp"
#include "transport/tiles.hpp"

namespace sr {

/// One way to an albedo at one effort, and its error.
struct AlbedoLap {
    std::string                          name;
    double                               effort;    ///< directions
    std::function<double(std::uint64_t)> once;      ///< an estimate, by the number of the repeat
    double                               error;     ///< root of the mean squared error
    double                               error_se;  ///< 0 for quadrature, which always errs alike
};

/// The mean of `of(u)` for n pairs of numbers that belong to a curve and a repeat.
template <class Of>
[[nodiscard]] double mean_of(std::uint64_t curve, std::uint64_t repeat, int n, const Of& of) {
    Rng    rng{curve, std::int64_t(repeat), n, 0};
    double sum = 0;
    for (int i = 0; i < n; ++i) {
        const double u = rng.uniform<double>(), v = rng.uniform<double>();
        sum += of(Vector2<double>{u, v});
    }
    return sum / n;
}

/// Estimates of n directions each, whatever the quality: their errors are in the text. Small ones vary most.
[[nodiscard]] inline int repeats_of(int n) {
    return (1 << 19) / n;
}

/// All efforts of one way to draw.
/// @param curve  number of the way: with the same random numbers, all of them would err alike
/// @param of     (u) -> what the direction drawn with u counts
template <class Of>
void add_sampled(std::vector<AlbedoLap>& laps, const std::string& way, std::uint64_t curve, double truth,
                 int threads, const Of& of) {
    for (int n = 16; n <= 4096; n *= 4) {
        const auto          once = [=](std::uint64_t repeat) { return mean_of(curve, repeat, n, of); };
        std::vector<double> squares(std::size_t(repeats_of(n)));
        for_each_pixel(repeats_of(n), 1, {.threads = threads}, [&](int x, int) {
            const double off        = once(std::uint64_t(x)) - truth;
            squares[std::size_t(x)] = off * off;
        });
        Running mean;
        for (const double square : squares) mean.add(square);
        const double error = std::sqrt(mean.mean());
        laps.push_back({way, double(n), once, error, error > 0 ? mean.standard_error() / (2 * error) : 0});
    }
}

/// All efforts of quadrature, whose directions are there before the clock starts.
template <class Lobe>
void add_quadrature(std::vector<AlbedoLap>& laps, const Lobe& lobe, const Vector3<double>& wo, double truth,
                    int finest) {
    for (int n = 3; n <= finest; n = n * 3 / 2 + 1) {
        const auto once = [=, rule = hemisphere_rule(n)](std::uint64_t) { return albedo(lobe, wo, rule); };
        laps.push_back({"quadrature", 2.0 * n * n, once, std::abs(once(0) - truth), 0});
    }
}

/// Times all laps, and charts them.
inline void chart_albedo(course::Chart chart, const std::vector<AlbedoLap>& laps, course::Quality quality) {
    double                    sum = 0;  // looked at below: work whose result nobody needs is optimised away
    std::vector<course::Work> work;
    std::vector<int>          times;  // as many as give the clock something to measure
    for (const auto& lap : laps) {
        times.push_back(lap.effort < 4096 ? int(4096 / lap.effort) + 1 : 1);
        work.push_back({lap.name, [&sum, &lap, n = times.back()] {
                            for (int i = 0; i < n; ++i) sum += lap.once(std::uint64_t(i));
                        }});
    }
    const auto timings = course::measure(work, quality == course::Quality::draft ? 3 : 25);
    if (!(sum > 0)) throw std::logic_error("all albedos are 0");
    for (std::size_t i = 0; i < laps.size(); ++i)
        chart.row({laps[i].name, laps[i].effort, timings[i].seconds / times[i], laps[i].error,
                   laps[i].error_se, 1e6 * timings[i].seconds / times[i]});
}

[[nodiscard]] inline course::Axes albedo_axes() {
    auto columns = course::speed_accuracy({"microseconds"});
    columns.x    = "microseconds";
    return {.x       = "time for an albedo, one thread [$\\mu$s]",
            .y       = "error of the albedo",
            .log     = course::axis::xy,
            .columns = columns};
}

/// The exponent with which the error of one way falls as its effort grows. Its own error comes from those of the
/// points: five are too few to show it by their scatter.
[[nodiscard]] inline Slope slope_of(const std::vector<AlbedoLap>& laps, const std::string& name) {
    std::vector<double>   effort;
    std::vector<Estimate> errors;
    for (const auto& lap : laps) {
        if (lap.name != name) continue;
        effort.push_back(lap.effort);
        errors.push_back({lap.error, lap.error_se});
    }
    return log_log_slope(effort, errors);
}

/// The lap of a way at an effort.
[[nodiscard]] inline const AlbedoLap& lap_of(const std::vector<AlbedoLap>& laps, const std::string& name,
                                             double effort) {
    for (const auto& lap : laps) {
        if (lap.name == name && lap.effort == effort) return lap;
    }
    throw std::out_of_range("no lap of " + name);
}

/// The race of Phong's lobe with this exponent, seen from 45 degrees.
/// @param curve  number of the first of its ways
[[nodiscard]] inline std::vector<AlbedoLap> race_phong(double e, int finest, std::uint64_t curve,
                                                       int threads) {
    const Phong            lobe(e);
    const Vector3<double>  wo    = at_angle(-45);
    const double           truth = lobe.f({0, 0, 1}, {0, 0, 1}) * phong_albedo(e, radians(45));
    std::vector<AlbedoLap> laps;
    add_sampled(laps, "uniform", curve, truth, threads, [=](Vector2<double> u) {
        const auto wi = sample_uniform_hemisphere(u);
        return lobe.f(wo, wi) * wi.z / pdf_uniform_hemisphere(wi).value;
    });
    add_sampled(laps, "cosine", curve + 1, truth, threads, [=](Vector2<double> u) {
        const auto wi = sample_cosine_hemisphere(u);
        return lobe.f(wo, wi) * wi.z / pdf_cosine_hemisphere(wi).value;
    });
    add_sampled(laps, "lobe", curve + 2, truth, threads, [=](Vector2<double> u) {
        const auto one = lobe.sample(wo, u, TransportMode::radiance);
        return one ? one->weight : 0;
    });
    add_quadrature(laps, lobe, wo, truth, finest);
    return laps;
}

/// The diffuse lobe, drawn uniformly, and glass seen from inside under 30 degrees, one of its two ways drawn.
[[nodiscard]] inline std::vector<AlbedoLap> race_others(std::uint64_t curve, int threads) {
    std::vector<AlbedoLap> laps;
    add_sampled(laps, "diffuse, uniform", curve, 1, threads, [](Vector2<double> u) {
        const auto wi = sample_uniform_hemisphere(u);
        return Diffuse<double>{}.f({0, 0, 1}, wi) * wi.z / pdf_uniform_hemisphere(wi).value;
    });
    const Dielectric<double> glass{1.5};
    const Vector3<double>    wo   = -at_angle(30);
    const auto               both = glass.branches(wo, TransportMode::radiance);
    add_sampled(laps, "glass, one way", curve + 1, both.reflected.weight + both.refracted->weight, threads,
                [=](Vector2<double> u) { return glass.sample(wo, u, TransportMode::radiance)->weight; });
    return laps;
}

}  // namespace sr
