#pragma once
/// @file tiles.hpp
/// The loop over an image's pixels, shared out to threads in small squares.

#include <functional>

namespace sr {

/// How a loop over an image is carried out. Neither changes what is computed.
struct TileLoop {
    int                                   threads = 1;   ///< 0: one for each processor
    std::function<void(int done, int of)> on_tile = {};  ///< told as tiles are finished, from any thread
};

/// Calls pixel(x, y) once for each pixel, tile by tile. Tiles run at the same time: `pixel` may write to its
/// own pixel and to nothing else. Of the exceptions thrown by `pixel` or `on_tile`, one is passed on.
void for_each_pixel(int width, int height, const TileLoop& loop,
                    const std::function<void(int x, int y)>& pixel);

}  // namespace sr
