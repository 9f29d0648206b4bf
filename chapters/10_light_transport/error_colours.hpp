#pragma once
/// @file error_colours.hpp
/// Section 10.10: numbers as colours, with their scale.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "image/image.hpp"
#include "math/vector.hpp"
#include "radiometry/spectrum.hpp"

namespace sr {

/// From black by violet and orange to pale yellow, on a screen: five colours of Van der Walt and Smith's "inferno", and
/// between them straight lines. The lightness grows all along, so that it reads in grey as well.
/// @param share  0 to 1; what lies outside has the colour of the end
[[nodiscard]] inline Spectrum colour_of_share(double share) {
    constexpr std::array<Vector3<double>, 5> stops{
        {{0.00, 0.00, 0.02}, {0.34, 0.06, 0.43}, {0.74, 0.22, 0.33}, {0.98, 0.56, 0.04}, {0.99, 1.00, 0.64}}};
    const double at     = std::clamp(share, 0.0, 1.0) * double(stops.size() - 1);
    const auto   first  = std::min(std::size_t(at), stops.size() - 2);
    const auto   shown  = mix(stops[first], stops[first + 1], at - double(first));
    const auto   linear = [](double v) {  // the inverse of sRGB's curve
        return float(v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4));
    };
    return {linear(shown.x), linear(shown.y), linear(shown.z)};
}

/// Values from a tenth of `middle` to ten times it in 40 steps of equal ratios. Below is the scale, a notch at the
/// middle and at half and twice it.
/// @pre middle > 0
[[nodiscard]] inline Image<Spectrum> map_of_ratios(const Image<float>& values, double middle) {
    const auto colour = [&](double value) {
        return colour_of_share(std::round(20 * (std::log10(value / middle) + 1)) / 40);
    };
    const int       width = values.width(), bar = std::max(8, width / 16);
    Image<Spectrum> film(width, values.height() + bar);
    for (int y = 0; y < values.height(); ++y)
        for (int x = 0; x < width; ++x) film(x, y) = colour(double(values(x, y)));
    const auto ratio = [&](int x) { return std::pow(10, 2.0 * x / width - 1); };
    for (int x = 0; x < width; ++x) {
        bool notched = false;
        for (const double notch : {0.5, 1.0, 2.0}) notched |= ratio(x) <= notch && notch < ratio(x + 1);
        for (int y = 0; y < bar; ++y)
            film(x, values.height() + y) =
                y < 2 || (notched && y < bar / 2) ? Spectrum{1, 1, 1} : colour(middle * ratio(x));
    }
    return film;
}

}  // namespace sr
