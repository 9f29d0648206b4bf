/// @file tiles.cpp

#include "transport/tiles.hpp"

#include <tbb/global_control.h>
#include <tbb/info.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <atomic>

namespace sr {

namespace {
constexpr int tile_side = 16;  // [pixel]: small enough to share out evenly, large enough to keep caches warm
}

void for_each_pixel(int width, int height, const TileLoop& loop,
                    const std::function<void(int x, int y)>& pixel) {
    const int        columns = (width + tile_side - 1) / tile_side;
    const int        rows    = (height + tile_side - 1) / tile_side;
    std::atomic<int> done    = 0;

    const auto tile = [&](int index) {
        const int x_begin = index % columns * tile_side;
        const int y_begin = index / columns * tile_side;
        for (int y = y_begin; y < std::min(y_begin + tile_side, height); ++y) {
            for (int x = x_begin; x < std::min(x_begin + tile_side, width); ++x) pixel(x, y);
        }
        const int count = ++done;
        if (loop.on_tile) loop.on_tile(count, rows * columns);
    };

    const int                 threads = loop.threads > 0 ? loop.threads : tbb::info::default_concurrency();
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, std::size_t(threads));
    tbb::task_arena           arena(threads);
    arena.execute([&] { tbb::parallel_for(0, rows * columns, tile); });
}

}  // namespace sr
