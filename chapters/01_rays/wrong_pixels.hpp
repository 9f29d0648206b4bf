#pragma once
/// @file wrong_pixels.hpp
/// How many pixels name another triangle than they should?

#include <algorithm>
#include <concepts>
#include <vector>

#include "scene/visible.hpp"

namespace sr {

struct Pixel {
    int x, y;
};

[[nodiscard]] inline std::vector<Pixel> every_pixel(int width, int height) {
    std::vector<Pixel> result;
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) result.push_back({x, y});
    }
    return result;
}

/// Of the pixels in `where`, those that name another triangle than the exact image.
/// @pre both images have the same size
template <std::floating_point T>
[[nodiscard]] int wrong_pixels(const VisibilityImage<T>& image, const VisibilityImage<double>& exact,
                               const std::vector<Pixel>& where) {
    return int(std::count_if(where.begin(), where.end(),
                             [&](Pixel p) { return image(p.x, p.y).face != exact(p.x, p.y).face; }));
}

/// Their share of the whole image [%].
template <std::floating_point T>
[[nodiscard]] double percent_wrong(const VisibilityImage<T>& image, const VisibilityImage<double>& exact) {
    const auto all = every_pixel(exact.width(), exact.height());
    return 100.0 * wrong_pixels(image, exact, all) / double(all.size());
}

}  // namespace sr
