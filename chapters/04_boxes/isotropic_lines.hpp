#pragma once
/// @file isotropic_lines.hpp
/// Lines that come from everywhere alike, and means over many of them that are the same for any number of threads.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

#include "geometry/ray.hpp"
#include "geometry/sphere.hpp"
#include "math/frame.hpp"
#include "sampling/rng.hpp"
#include "transport/tiles.hpp"

namespace sr {

/// A line that meets the ball, each as likely: its direction is uniform on the sphere, and where it passes the
/// centre is uniform in the disk across it. The direction has length 1, and all of the ball is in front of the origin.
/// @param ball  around all that lines are to meet
[[nodiscard]] inline Ray<double> isotropic_line(const Sphere<double>& ball, Rng& rng) {
    const double z = 1 - 2 * rng.uniform<double>(), around = 2 * std::numbers::pi * rng.uniform<double>();
    const double r = std::sqrt(std::fmax(0.0, 1 - z * z));
    const Vector3<double> d{r * std::cos(around), r * std::sin(around), z};
    const double          from_centre = ball.radius * std::sqrt(rng.uniform<double>());
    const double          angle       = 2 * std::numbers::pi * rng.uniform<double>();
    const Vector3<double> across{from_centre * std::cos(angle), from_centre * std::sin(angle), 0};
    return {ball.centre + frame_around(d).to_world(across) - 2 * ball.radius * d, d};
}

/// How many lines, drawn from which seed, by how many threads.
struct Draw {
    int           lines   = 100'000;
    std::uint64_t seed    = 1;
    int           threads = 1;
};

/// What `see(result, line)` makes of many lines, with `Result::merge` over blocks of a fixed size.
template <class Result, class See>
[[nodiscard]] Result over_lines(const Sphere<double>& ball, const Draw& draw, const See& see) {
    constexpr int       side = 32;  // x side blocks, in tiles of 16 x 16
    std::vector<Result> parts(side * side);
    for_each_pixel(side, side, {.threads = draw.threads}, [&](int x, int y) {
        const int part = y * side + x;
        for (int i = part; i < draw.lines; i += side * side) {
            Rng rng{draw.seed, i, 0, 0};
            see(parts[std::size_t(part)], isotropic_line(ball, rng));
        }
    });
    Result whole;
    for (const auto& part : parts) whole.merge(part);
    return whole;
}

}  // namespace sr
