#pragma once
/// @file adaptive_picture.hpp
/// Section 9.9: the same number of samples for a picture, shared out evenly and by where they are needed.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "allocation.hpp"
#include "image/image.hpp"
#include "lit_floor.hpp"
#include "math/square.hpp"
#include "moments.hpp"
#include "statistics/running.hpp"
#include "transport/tiles.hpp"

namespace sr {

/// The floor by so many samples in each pixel, row after row.
/// @param stream  of random numbers
[[nodiscard]] inline std::vector<Running> sample_floor(int size, const std::vector<int>& counts,
                                                       std::uint64_t stream, int threads) {
    std::vector<Running> pixels(counts.size());
    for_each_pixel(size, size, {.threads = threads}, [&](int x, int y) {
        const auto i     = std::size_t(y) * std::size_t(size) + std::size_t(x);
        const auto point = floor_at(x, y, size);
        Rng        rng{stream, x, y, 0};
        for (int k = 0; k < counts[i]; ++k) pixels[i].add(point.sample(draw_pair(rng)));
    });
    return pixels;
}

/// The standard deviations of one sample in each pixel, as the pilot's samples of it and its neighbours say, two to
/// each side. One more sample of 0 and one of the most that there can be are taken for seen, as Laplace did.
[[nodiscard]] inline std::vector<double> deviations_of(int size, const std::vector<Running>& pilot) {
    std::vector<double> all(pilot.size());
    for (int y = 0; y < size; ++y) {
        for (int x = 0; x < size; ++x) {
            Running around;
            for (int v = std::max(y - 2, 0); v <= std::min(y + 2, size - 1); ++v)
                for (int u = std::max(x - 2, 0); u <= std::min(x + 2, size - 1); ++u)
                    around.merge(pilot[std::size_t(v) * std::size_t(size) + std::size_t(u)]);
            // where all samples are alike, it is not known to be 0
            around.add(0);
            around.add(floor_at(x, y, size).most());
            all[std::size_t(y) * std::size_t(size) + std::size_t(x)] = std::sqrt(around.variance());
        }
    }
    return all;
}

/// How many samples pixels get on average, and how many of them the pilot takes.
inline constexpr int samples_of_pixel = 16, samples_of_pilot = 2;

/// The numbers of samples in each pixel that a pilot leads to; with the pilot's own, as many as samples_of_pixel each.
[[nodiscard]] inline std::vector<int> counts_by_pilot(int size, int threads) {
    const std::vector<int> few(std::size_t(size) * std::size_t(size), samples_of_pilot);
    const auto             pilot = sample_floor(size, few, 1, threads);
    return allocated(deviations_of(size, pilot), (samples_of_pixel - samples_of_pilot) * size * size, 1);
}

/// The gain that (9.26) promises, if these deviations were the true ones.
[[nodiscard]] inline double promised_gain(const std::vector<Running>& pixels) {
    Running deviations, variances;
    for (const Running& pixel : pixels) {
        deviations.add(std::sqrt(pixel.variance()));
        variances.add(pixel.variance());
    }
    return variances.mean() / square(deviations.mean());
}

/// Root of the mean squared error over the mean irradiance.
[[nodiscard]] inline double relative_error(int size, const std::vector<Running>& pixels) {
    Running squares, exact;
    for (int y = 0; y < size; ++y) {
        for (int x = 0; x < size; ++x) {
            const double E = floor_at(x, y, size).exact();
            squares.add(square(pixels[std::size_t(y) * std::size_t(size) + std::size_t(x)].mean() - E));
            exact.add(E);
        }
    }
    return std::sqrt(squares.mean()) / exact.mean();
}

}  // namespace sr
