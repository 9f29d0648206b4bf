#pragma once
/// @file picture_grid.hpp

#include <cstddef>
#include <vector>

#include "image/image.hpp"
#include "radiometry/spectrum.hpp"

namespace sr {

/// Pictures of one size side by side, row after row, on white.
/// @pre there are full rows, and one at least
[[nodiscard]] inline Image<Spectrum> grid_of(const std::vector<Image<Spectrum>>& pictures, int columns) {
    constexpr int   gap   = 3;  // [pixel]
    const int       width = pictures[0].width(), height = pictures[0].height();
    const int       rows = int(pictures.size()) / columns;
    Image<Spectrum> grid(columns * (width + gap) - gap, rows * (height + gap) - gap, {1, 1, 1});
    for (int i = 0; i < columns * rows; ++i)
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x)
                grid(i % columns * (width + gap) + x, i / columns * (height + gap) + y) =
                    pictures[std::size_t(i)](x, y);
    return grid;
}

}  // namespace sr
