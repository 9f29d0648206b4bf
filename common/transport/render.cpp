/// @file render.cpp

#include "transport/render.hpp"

#include <fmt/format.h>

#include <cmath>

namespace sr {

BadSample::BadSample(int x, int y, int sample, Spectrum L)
    : std::runtime_error(
          fmt::format("sample {} of pixel ({}, {}) is ({}, {}, {}); must be finite and not negative", sample,
                      x, y, L.r, L.g, L.b)) {}

int grid_side(int samples) {
    const int side = int(std::lround(std::sqrt(double(samples))));
    if (!(samples >= 1 && side * side == samples))
        throw std::invalid_argument(
            fmt::format("{} samples a pixel: must be a square number, 1, 4, 9, ...", samples));
    return side;
}

}  // namespace sr
