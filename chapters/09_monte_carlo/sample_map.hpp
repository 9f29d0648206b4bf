#pragma once
/// @file sample_map.hpp
/// Section 9.9: how many samples each pixel got, as a picture with its scale.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "image/image.hpp"
#include "radiometry/spectrum.hpp"

namespace sr {

/// The grey that stands at this share of the way from black to white on a screen: the inverse of sRGB's curve.
/// @param share  0 to 1; what lies outside has the grey of the end
[[nodiscard]] inline Spectrum grey_on_screen(double share) {
    const double v    = std::clamp(share, 0.0, 1.0);
    const auto   grey = float(v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4));
    return {grey, grey, grey};
}

/// The counts, black for 0 and white for 64 and more, in equal steps; below them the scale, a notch every 16.
[[nodiscard]] inline Image<Spectrum> map_of_samples(int size, const std::vector<int>& counts) {
    constexpr double most = 64, notch = 16;
    const int        bar = std::max(8, size / 16);
    Image<Spectrum>  film(size, size + bar);
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x)
            film(x, y) = grey_on_screen(counts[std::size_t(y) * std::size_t(size) + std::size_t(x)] / most);
    const Spectrum orange{1.0F, 0.3F, 0.0F};
    for (int x = 0; x < size; ++x) {
        const double here = most * x / size, next = most * (x + 1) / size;
        const bool   notched = x > 0 && std::floor(here / notch) < std::floor(next / notch);
        for (int y = 0; y < bar; ++y)
            film(x, size + y) = y < 2 || (notched && y < bar / 2) ? orange : grey_on_screen(here / most);
    }
    return film;
}

}  // namespace sr
