#pragma once
/// @file box_by_paths.hpp
/// Section 10.1: the Cornell box by independent random paths, and how wrong it is.

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "math/square.hpp"
#include "sampling/random_point.hpp"
#include "scene/cornell_box.hpp"
#include "statistics/estimate.hpp"
#include "statistics/running.hpp"
#include "transport/image_error.hpp"
#include "transport/traced.hpp"

namespace sr {

/// So many paths in each pixel, which know nothing of each other.
[[nodiscard]] inline Image<Spectrum> box_by_paths(Strategy strategy, std::uint32_t paths, int side,
                                                  const TileLoop& loop, std::uint64_t seed = 1) {
    return traced<RandomPoint>(cornell_box(), cornell_box_camera(side), {.strategy = strategy},
                               {.seed = seed, .samples = paths}, loop)
        .mean();
}

/// What such pictures are held against: a small box by many good paths.
class SmallBox {
public:
    static constexpr int side = 12;

    explicit SmallBox(int threads)
        : threads_{threads},
          reference_{traced(cornell_box(), cornell_box_camera(side), {}, {.seed = 7, .samples = 512},
                            {.threads = threads})
                         .mean()},
          mask_{without_emitters(cornell_box(), cornell_box_camera(side))} {}

    /// The relative RMSE of a picture with so many paths a pixel, the root of the mean square of that of several: eight
    /// at least, and more of those that take less time and vary more.
    [[nodiscard]] Estimate error(Strategy strategy, std::uint32_t paths) const {
        Running squares;
        for (std::uint64_t seed = 101; seed <= 100 + std::clamp(512 / paths, 8U, 128U); ++seed)
            squares.add(square(relative_rmse(box_by_paths(strategy, paths, side, {.threads = threads_}, seed),
                                             reference_, mask_)));
        const double root = std::sqrt(squares.mean());
        return {root, squares.standard_error() / (2 * root)};
    }

private:
    int             threads_;
    Image<Spectrum> reference_;
    PixelMask       mask_;
};

/// The share of pixels that are black after so many paths.
[[nodiscard]] inline Estimate black_pixels(Strategy strategy, std::uint32_t paths, int side, int threads) {
    const auto picture = box_by_paths(strategy, paths, side, {.threads = threads});
    int        black   = 0;
    for (const Spectrum& L : picture.pixels()) black += L == Spectrum{} ? 1 : 0;
    return share(black, picture.pixels().size());
}

}  // namespace sr
