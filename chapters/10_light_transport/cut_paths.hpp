#pragma once
/// @file cut_paths.hpp
/// Section 10.4: paths that are cut after so many bounces, and paths that end by chance, error against time.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

#include "course/claims.hpp"
#include "sampling/random_point.hpp"
#include "scene/cornell_box.hpp"
#include "statistics/estimate.hpp"
#include "statistics/running.hpp"
#include "transport/image_error.hpp"
#include "transport/traced.hpp"

namespace sr {

/// Where paths end.
struct PathEnd {
    std::string name;
    PathOptions options;
};

[[nodiscard]] inline std::vector<PathEnd> path_ends() {
    std::vector<PathEnd> all;
    for (const int bounces : {2, 4, 8, 16})
        all.push_back({fmt::format("at most {}", bounces), {.bounces = bounces, .roulette = bounces}});
    for (const int from : {0, 3, 8})
        all.push_back({fmt::format("roulette from {}", from), {.roulette = from}});
    return all;
}

/// Pictures of the Cornell box by paths that end somehow, with so many samples in each pixel.
struct PathEndLap {
    PathEnd       end;
    std::uint32_t samples;
    double        seconds = std::numeric_limits<double>::infinity();  ///< of the fastest
    Running       error   = {};                                       ///< relative RMSE
};

/// Four pictures of each lap. All laps take turns, so that what else the machine does hits all of them alike.
[[nodiscard]] inline std::vector<PathEndLap> race_path_ends(std::uint32_t most, std::uint32_t of_reference,
                                                            int threads) {
    constexpr int    repeats = 4;
    const Scene      scene   = cornell_box();
    const auto       camera  = cornell_box_camera(24);
    const auto       mask    = without_emitters(scene, camera);
    const TileLoop   loop{.threads = threads};
    course::Progress progress("10.4 paths that end", repeats + 1);
    const auto reference = traced(scene, camera, {}, {.seed = 1040, .samples = of_reference}, loop).mean();
    progress.tick();

    std::vector<PathEndLap> laps;
    for (const auto& end : path_ends())
        for (std::uint32_t samples = 4; samples <= most; samples *= 4) laps.push_back({end, samples});
    for (std::uint64_t repeat = 0; repeat < repeats; ++repeat) {
        for (auto& lap : laps) {
            Image<Spectrum>   image(1, 1);
            const PassOptions pass{.seed = 1041 + repeat, .samples = lap.samples};
            lap.seconds =
                std::min(lap.seconds, course::seconds_of([&] {
                             image = traced<RandomPoint>(scene, camera, lap.end.options, pass, loop).mean();
                         }));
            lap.error.add(relative_rmse(image, reference, mask));
        }
        progress.tick();
    }
    return laps;
}

/// Error against time.
inline void chart_path_ends(course::Chapter& chapter) {
    const auto& options = chapter.options();
    const bool  draft   = options.quality == course::Quality::draft;
    auto        chart   = chapter.chart("path_ends", "The Cornell box, by paths that end",
                                        {.x       = "time [s]",
                                         .y       = "relative error",
                                         .log     = course::axis::xy,
                                         .columns = course::speed_accuracy()});
    for (const auto& lap : race_path_ends(draft ? 16 : 256, draft ? 1024 : 16'384, options.threads))
        chart.row(
            {lap.end.name, int(lap.samples), lap.seconds, lap.error.mean(), lap.error.standard_error()});
    chart.caption("24 x 24 pixels; the mean error of four pictures each.");
}

/// Of the light in the box's picture, the lamp itself aside, the share that paths of more than so many bounces bring
/// [1].
struct LongPaths {
    static constexpr std::array limits{2, 4, 8};

    std::array<Estimate, limits.size()> missing;
};

/// Light that paths bring: all of it, and what needs more bounces than each limit.
struct LightByBounces {
    double                                       all = 0;
    std::array<double, LongPaths::limits.size()> beyond{};

    void add(int bounces, double L) {
        all += L;
        for (std::size_t k = 0; k < beyond.size(); ++k)
            if (bounces > LongPaths::limits[k]) beyond[k] += L;
    }
    void add(const LightByBounces& other) {
        all += other.all;
        for (std::size_t k = 0; k < beyond.size(); ++k) beyond[k] += other.beyond[k];
    }
};

/// Of a picture of 24 x 24 pixels by 64 paths each.
[[nodiscard]] inline LightByBounces light_by_bounces(const PathTracer& tracer, std::uint64_t seed,
                                                     int threads) {
    const auto            camera = convert<float>(cornell_box_camera(24));
    Image<LightByBounces> sums(camera.width, camera.height);
    for_each_pixel(camera.width, camera.height, {.threads = threads}, [&](int x, int y) {
        for (std::uint32_t i = 0; i < 64; ++i) {
            SobolPoint point(SampleId{seed, x, y, i, 64});
            const Vec2 at = Vec2{x, y} + point.pair<float>();
            PathCount  count;
            tracer.each_light(camera.ray(at), point, count, [&](std::string_view way, Spectrum L) {
                // bounces are all but L and E
                if (way != "LE") sums(x, y).add(int(way.size()) - 2, double(mean(L)));
            });
        }
    });
    LightByBounces total;
    for (const auto& sum : sums.pixels()) total.add(sum);
    return total;
}

/// By eight independent pictures.
[[nodiscard]] inline LongPaths light_of_long_paths(int threads) {
    const PathTracer                              tracer(cornell_box());
    std::array<Running, LongPaths::limits.size()> shares;
    for (std::uint64_t seed = 1050; seed < 1058; ++seed) {
        const auto light = light_by_bounces(tracer, seed, threads);
        for (std::size_t k = 0; k < shares.size(); ++k) shares[k].add(light.beyond[k] / light.all);
    }
    LongPaths result;
    for (std::size_t k = 0; k < shares.size(); ++k)
        result.missing[k] = {shares[k].mean(), shares[k].standard_error()};
    return result;
}

/// Within four standard errors of what the text says.
inline void claim_cut_paths(course::Chapter& chapter) {
    const course::Claims claim{chapter, "10.4"};
    const auto           long_paths = light_of_long_paths(chapter.options().threads);
    course::Rows         table{{"bounces at most", "missing [%]", "+-"}};
    for (const auto& [k, printed, digit] :
         {std::tuple{std::size_t{0}, 24.0, 1.0}, {1, 6.3, 0.1}, {2, 0.52, 0.01}}) {
        const auto missing = percent(long_paths.missing[k]);
        claim(fmt::format("Cornell box, at most {} bounces: light that is missing [%]", LongPaths::limits[k]),
              printed, missing.value, digit / 2 + 4 * missing.error);
        table.add({LongPaths::limits[k], missing.value, missing.error});
    }
    chapter.say(table);
}

}  // namespace sr
