#pragma once
/// @file sampled.hpp
/// Means of random numbers with their errors, and charts that show both.

#include <string>
#include <vector>

#include "course/chapter.hpp"
#include "math/vector.hpp"
#include "sampling/rng.hpp"
#include "statistics/estimate.hpp"
#include "statistics/running.hpp"
#include "transport/tiles.hpp"

namespace sr {

/// How much work a mean is worth: 64 blocks of so many samples.
struct Effort {
    int threads;
    int samples_per_block;
    int stream = 0;  ///< means with different ones are independent
};

/// Mean and variance of draw(rng) over the blocks, which several threads share out among themselves: the same for any
/// number of them.
template <class Draw>
[[nodiscard]] Running sampled(const Effort& effort, const Draw& draw) {
    constexpr int        blocks = 64, side = 16;  // a block stands at every 16th pixel, in a tile of its own
    std::vector<Running> parts(blocks);
    for_each_pixel(blocks * side, 1, {.threads = effort.threads}, [&](int x, int) {
        if (x % side != 0) return;
        Rng rng{5, x, effort.stream, 0};
        for (int i = 0; i < effort.samples_per_block; ++i) parts[std::size_t(x / side)].add(draw(rng));
    });
    Running all;
    for (const auto& part : parts) all.merge(part);
    return all;
}

/// Two numbers in [0, 1).
[[nodiscard]] inline Vector2<double> random_point(Rng& rng) {
    const double x = rng.uniform<double>();
    return {x, rng.uniform<double>()};
}

[[nodiscard]] inline Estimate estimate(const Running& of) {
    return {of.mean(), of.standard_error()};
}

/// A number as the text prints it; its last digit is worth `digit`.
struct Printed {
    double value, digit;
};

/// What was estimated and its standard error, as the text prints them.
inline void claim_estimate(course::Chapter& chapter, const std::string& what, Estimate of, Printed value,
                           Printed error) {
    chapter.claim(what, {.expected = value.value, .measured = of.value, .tolerance = value.digit / 2});
    chapter.claim(what + ": standard error",
                  {.expected = error.value, .measured = of.error, .tolerance = error.digit / 2});
}

}  // namespace sr
