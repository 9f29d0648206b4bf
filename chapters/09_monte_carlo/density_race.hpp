#pragma once
/// @file density_race.hpp
/// Section 9.5: the densities of a lamp's irradiance, error against time.

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "course/claims.hpp"
#include "moments.hpp"
#include "repeated.hpp"
#include "square_lamp.hpp"

namespace sr {

/// One density at one number of samples, and its error.
struct DensityLap {
    std::string                          name;
    int                                  samples;
    std::function<double(std::uint64_t)> once;  ///< an estimate, by the number of the repeat
    Estimate                             error;
};

/// All numbers of samples of one density, 16 to 4096.
/// @param stream  of random numbers: with the same ones, all densities would err alike
/// @param each    samples that one draw takes
/// @param draw    (Rng&) -> an estimate
template <class Draw>
void add_density(std::vector<DensityLap>& laps, const std::string& name, std::uint64_t stream, int each,
                 int threads, const Draw& draw) {
    for (int n = 16; n <= 4096; n *= 4) {
        const auto once = [=](std::uint64_t repeat) {
            Rng    rng{stream, std::int64_t(repeat), n, 0};
            double sum = 0;
            for (int i = 0; i < n; i += each) sum += draw(rng);
            return sum * each / n;
        };
        const auto squares = squared_errors(std::max((1 << 18) / n, 256), threads, SquareLamp::exact(), once);
        laps.push_back({name, n, once, root_mean_square(squares)});
    }
}

[[nodiscard]] inline std::vector<DensityLap> race_densities(int threads) {
    const SquareLamp        lamp;
    std::vector<DensityLap> laps;
    const auto              add = [&](const std::string& name, std::uint64_t stream, auto way) {
        add_density(laps, name, stream, 1, threads, [=](Rng& rng) { return (lamp.*way)(draw_pair(rng)); });
    };
    add("uniform", 301, &SquareLamp::by_uniform);
    add("cosine", 302, &SquareLamp::by_cosine);
    add("area", 303, &SquareLamp::by_area);
    add_density(laps, "area and cosine", 304, 2, threads, [=](Rng& rng) {
        const auto u = draw_pair(rng), v = draw_pair(rng);
        return lamp.by_both(u, v);
    });
    add("solid angle", 305, &SquareLamp::by_solid_angle);
    return laps;
}

[[nodiscard]] inline double error_of(const std::vector<DensityLap>& laps, const std::string& name,
                                     int samples) {
    for (const auto& lap : laps)
        if (lap.name == name && lap.samples == samples) return lap.error.value;
    throw std::out_of_range("no lap of " + name);
}

inline void claim_densities(course::Chapter& chapter, const std::vector<DensityLap>& laps) {
    const course::Claims claim{chapter, "9.5"};
    claim("irradiance of the square", 1.3872, SquareLamp::exact(), 5e-5);
    claim("samples by area for one by solid angle", 35,
          square(error_of(laps, "area", 16) / error_of(laps, "solid angle", 16)), 0.5);
    for (const auto& [name, error] : {std::pair{"uniform", 0.526},
                                      {"cosine", 0.391},
                                      {"area", 0.630},
                                      {"area and cosine", 0.421},
                                      {"solid angle", 0.106}})
        claim(fmt::format("{}: error of 16 samples", name), error, error_of(laps, name, 16), 5e-4);
}

/// Times all laps on one thread, and charts them.
inline void chart_densities(course::Chapter& chapter, const std::vector<DensityLap>& laps) {
    auto columns = course::speed_accuracy({"microseconds"});
    columns.x    = "microseconds";
    auto   chart = chapter.chart("densities", "A near lamp's irradiance, by five densities",
                                 {.x       = "time for an estimate, one thread [$\\mu$s]",
                                  .y       = "error, root mean square",
                                  .log     = course::axis::xy,
                                  .columns = columns});
    double sum   = 0;  // looked at below: work whose result nobody needs is optimised away
    std::vector<course::Work> work;
    for (const auto& lap : laps) {
        work.push_back({lap.name, [&sum, &lap] {
                            for (int i = 0; i < 4096 / lap.samples; ++i) sum += lap.once(std::uint64_t(i));
                        }});
    }
    const auto timings = course::measure(work, chapter.options().quality == course::Quality::draft ? 3 : 25);
    if (!(sum > 0)) throw std::logic_error("all irradiances are 0");
    for (std::size_t i = 0; i < laps.size(); ++i) {
        const auto&  lap     = laps[i];
        const double seconds = timings[i].seconds * lap.samples / 4096;
        chart.row({lap.name, lap.samples, seconds, lap.error.value, lap.error.error, 1e6 * seconds});
    }
    chart.name_at("area", 0);  // it ends upon the cosine's
    chart.caption("A square of side 2, half a unit overhead; 16 to 4096 samples.");
}

}  // namespace sr
