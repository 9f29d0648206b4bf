#pragma once
/// @file path_means.hpp
/// Means over random paths, which threads share.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "radiosity/rows.hpp"
#include "sampling/random_point.hpp"
#include "statistics/running.hpp"

namespace sr {

/// What one path brings: it adds to numbers that are 0.
using OncePerPath = std::function<void(RandomPoint& point, std::span<double> numbers)>;

/// The mean of each of so many numbers over so many paths. The same to the bit for any number of threads.
[[nodiscard]] inline std::vector<Running> path_means(int paths, std::size_t numbers, int threads,
                                                     const OncePerPath& once) {
    constexpr std::size_t             blocks = 64;
    std::vector<std::vector<Running>> parts(blocks, std::vector<Running>(numbers));
    for_each_row(blocks, {.threads = threads}, [&](std::size_t block) {
        std::vector<double> values(numbers);
        for (auto i = std::uint32_t(block); i < std::uint32_t(paths); i += blocks) {
            std::ranges::fill(values, 0);
            RandomPoint point(SampleId{.index = i});
            once(point, values);
            for (std::size_t k = 0; k < numbers; ++k) parts[block][k].add(values[k]);
        }
    });
    std::vector<Running> all(numbers);
    for (const auto& part : parts)
        for (std::size_t k = 0; k < numbers; ++k) all[k].merge(part[k]);
    return all;
}

/// Of one number, which each path returns.
/// @param radiance  (RandomPoint&) -> a number
template <class Radiance>
[[nodiscard]] Running path_mean(int paths, int threads, const Radiance& radiance) {
    return path_means(paths, 1, threads, [&](RandomPoint& point, std::span<double> numbers) {
        numbers[0] = double(radiance(point));
    })[0];
}

}  // namespace sr
