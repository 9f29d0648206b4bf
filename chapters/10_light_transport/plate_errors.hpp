#pragma once
/// @file plate_errors.hpp
/// Section 10.3: how noisy each lamp is in each plate, by three strategies.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "course/progress.hpp"
#include "math/square.hpp"
#include "plates_and_lamps.hpp"
#include "sampling/random_point.hpp"
#include "statistics/estimate.hpp"
#include "statistics/running.hpp"
#include "transport/traced.hpp"

namespace sr {

/// What is seen of one lamp in one plate, in blocks of paths.
struct PlateCell {
    Running radiance  = {};  ///< of the plate
    Running variances = {};  ///< of a path, the mean of the plate's pixels
};

using PlateCells = std::array<std::array<PlateCell, 4>, 4>;  ///< [plate][lamp]

inline constexpr int plates_side = 32, plate_passes = 32, plate_blocks = 8;  // for what is claimed

/// Adds a block's picture of one lamp.
inline void add_block(PlateCells& cells, std::size_t lamp, const std::array<PixelMask, 4>& masks,
                      const SampledImage& block) {
    const auto means = block.mean();
    const auto se    = block.standard_errors();
    for (std::size_t plate = 0; plate < 4; ++plate) {
        Running radiance, variance;
        for (std::size_t i = 0; i < masks[plate].pixels().size(); ++i)
            if (masks[plate].pixels()[i] != 0) {
                radiance.add(double(mean(means.pixels()[i])));
                variance.add(plate_passes * square(double(se.pixels()[i])));
            }
        cells[plate][lamp].radiance.add(radiance.mean());
        cells[plate][lamp].variances.add(variance.mean());
    }
}

/// All plates and lamps, by one strategy.
/// @param progress  gets a tick for each lamp
[[nodiscard]] inline PlateCells plate_cells(Strategy strategy, int threads, course::Progress& progress) {
    const auto               camera = plates_camera(plates_side);
    std::array<PixelMask, 4> masks{
        pixels_of_plate(plates_and_lamps(), camera, 0), pixels_of_plate(plates_and_lamps(), camera, 1),
        pixels_of_plate(plates_and_lamps(), camera, 2), pixels_of_plate(plates_and_lamps(), camera, 3)};
    const auto is_plate = [&](int x, int y) {
        return std::ranges::any_of(masks, [&](const PixelMask& mask) { return mask(x, y) != 0; });
    };
    PlateCells cells;
    for (std::size_t lamp = 0; lamp < 4; ++lamp) {
        const PathTracer tracer(plates_and_lamp(lamp), {.strategy = strategy, .bounces = 1});
        const auto       radiance = [&](const Ray<float>& ray, RandomPoint& point) {
            PathCount count;
            return tracer.radiance(ray, point, count);
        };
        for (std::uint64_t seed = 61; seed < 61 + plate_blocks; ++seed) {
            SampledImage block(convert<float>(camera), {.seed = seed, .samples = 1});
            for (int pass = 0; pass < plate_passes; ++pass)
                block.add_pass<RandomPoint>({.threads = threads}, radiance, is_plate);
            add_block(cells, lamp, masks, block);
        }
        progress.tick();
    }
    return cells;
}

/// The relative RMSE of a picture of one path a pixel. No reference is needed: pictures that are right on average are
/// as wrong as they vary.
/// @param radiance  of the plate, as it is best known
[[nodiscard]] inline Estimate error_of(const PlateCell& cell, double radiance) {
    const double root = std::sqrt(cell.variances.mean());
    return {root / radiance, cell.variances.standard_error() / (2 * root) / radiance};
}

}  // namespace sr
