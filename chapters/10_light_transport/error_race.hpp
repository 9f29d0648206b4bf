#pragma once
/// @file error_race.hpp
/// Section 10.9: the box by all strategies, each with its errors.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "math/square.hpp"
#include "sampling/random_point.hpp"
#include "scene/cornell_box.hpp"
#include "statistics/estimate.hpp"
#include "statistics/running.hpp"
#include "transport/image_error.hpp"
#include "transport/traced.hpp"

namespace sr {

/// A way to render.
struct Racer {
    std::string name;
    PathOptions paths;
    bool        by_sobol = true;
};

/// A racer's relative RMSE with so many samples in each pixel.
struct RaceLap {
    Racer         racer;
    std::uint32_t samples;
    Estimate      error;
};

inline const std::vector<Racer> racers{
    {"blind", {.strategy = Strategy::blind}},
    {"BSDF", {.strategy = Strategy::bsdf}},
    {"light", {.strategy = Strategy::light}},
    {"balance", {.strategy = Strategy::balance}},
    {"power", {.strategy = Strategy::power}},
    {"light, no roulette", {.strategy = Strategy::light, .roulette = 1000}},
    {"power, no roulette", {.strategy = Strategy::power, .roulette = 1000}},
    {"power, random", {.strategy = Strategy::power}, false},
};

/// The mean radiance of pixels that count [W/(m^2 sr)].
[[nodiscard]] inline double radiance_of(const Image<Spectrum>& film, const PixelMask& mask) {
    Running radiance;
    for (std::size_t i = 0; i < mask.pixels().size(); ++i)
        if (mask.pixels()[i] != 0) radiance.add(double(mean(film.pixels()[i])));
    return radiance.mean();
}

/// The Cornell box, small, and how wrong a picture of it is.
class ErrorRace {
public:
    static constexpr int side = 32;  ///< [pixel]

    /// @param samples  of each pixel of the picture that the others are held against; it takes paths of its own
    /// @param loop     of that picture; the others are rendered with as many threads
    ErrorRace(std::uint32_t samples, const TileLoop& loop)
        : loop_{.threads = loop.threads},
          scene_{cornell_box()},
          camera_{cornell_box_camera(side)},
          mask_{without_emitters(scene_, camera_)},
          reference_{traced(scene_, camera_, {}, {.seed = 1090, .samples = samples / 2}, loop, 2)} {}

    [[nodiscard]] SampledImage picture(const Racer& racer, std::uint64_t seed, std::uint32_t samples,
                                       const TileLoop& loop) const {
        return racer.by_sobol ? traced<SobolPoint>(scene_, camera_, racer.paths, {seed, samples}, loop)
                              : traced<RandomPoint>(scene_, camera_, racer.paths, {seed, samples}, loop);
    }

    /// Over four pictures of 16 samples, and no more than eight or fewer than one of others.
    [[nodiscard]] RaceLap lap(const Racer& racer, std::uint32_t samples) const {
        Running squares;
        for (std::uint64_t seed = 1; seed <= std::clamp(64U / samples, 1U, 8U); ++seed)
            squares.merge(squared_errors_of(picture(racer, seed, samples, loop_).mean()));
        const double rmse = std::sqrt(squares.mean());
        return {racer, samples, {rmse, squares.standard_error() / (2 * rmse)}};
    }

    [[nodiscard]] const Scene&          scene() const { return scene_; }
    [[nodiscard]] const Camera<double>& camera() const { return camera_; }
    [[nodiscard]] const PixelMask&      mask() const { return mask_; }
    [[nodiscard]] const SampledImage&   reference() const { return reference_; }
    /// Its standard error over its mean.
    [[nodiscard]] double error_of_reference() const { return reference_.relative_error(mask_); }

    /// Rays of all paths together.
    [[nodiscard]] PathCount count(const Racer& racer, std::uint32_t samples) const;

private:
    /// Of each pixel that counts, the mean over its channels; over the mean radiance, squared. Their mean is the
    /// square of relative_rmse, and pixels have errors of their own: they say how sure it is.
    [[nodiscard]] Running squared_errors_of(const Image<Spectrum>& film) const {
        const auto   reference = reference_.mean();
        const double radiance  = radiance_of(reference, mask_);
        Running      squares;
        for (std::size_t i = 0; i < mask_.pixels().size(); ++i) {
            const Spectrum &I = film.pixels()[i], &R = reference.pixels()[i];
            if (mask_.pixels()[i] != 0)
                squares.add(
                    (square(double(I.r - R.r)) + square(double(I.g - R.g)) + square(double(I.b - R.b))) / 3 /
                    square(radiance));
        }
        return squares;
    }

    TileLoop       loop_;
    Scene          scene_;
    Camera<double> camera_;
    PixelMask      mask_;
    SampledImage   reference_;
};

inline PathCount ErrorRace::count(const Racer& racer, std::uint32_t samples) const {
    const PathTracer tracer(scene_, racer.paths);
    const auto       camera = convert<float>(camera_);
    Image<PathCount> counts(side, side);
    for_each_pixel(side, side, loop_, [&](int x, int y) {
        for (std::uint32_t i = 0; i < samples; ++i) {
            SobolPoint point(SampleId{.seed = 1, .x = x, .y = y, .index = i, .count = samples});
            const Vec2 at = Vec2{x, y} + point.pair<float>();
            static_cast<void>(tracer.radiance(camera.ray(at), point, counts(x, y)));
        }
    });
    PathCount all;
    for (const auto& pixel : counts.pixels()) all += pixel;
    return all;
}

}  // namespace sr
