#pragma once
/// @file nodes_per_pixel.hpp
/// A picture of the work: how many nodes each pixel's ray asks.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "geometry/hierarchy.hpp"
#include "image/image.hpp"
#include "radiometry/spectrum.hpp"
#include "scene/camera.hpp"
#include "transport/tiles.hpp"

namespace sr {

/// The teapot, seen as in chapter 1.
[[nodiscard]] inline Camera<float> teapot_view(int width, int height) {
    const Vector3<double> eye{2.6, -8.2, 4.2}, target{0.32, 0, 1.4};
    return convert<float>(pinhole_camera<double>(eye, target - eye, {0, 0, 1}, 1.0, 0.86, width, height));
}

[[nodiscard]] inline Image<WalkCount> count_per_pixel(const Hierarchy<float>& hierarchy,
                                                      const Camera<float>& camera, const TileLoop& loop) {
    Image<WalkCount> counts(camera.width, camera.height);
    for_each_pixel(camera.width, camera.height, loop, [&](int x, int y) {
        (void)hierarchy.nearest(camera.ray_through_pixel(x, y), in_front<float>, counts(x, y));
    });
    return counts;
}

/// From black over purple, red and orange to pale yellow: brighter is more, in colour and in grey print.
/// @param share  0 to 1; what lies outside has the colour of the end
[[nodiscard]] inline Spectrum heat(double share) {
    constexpr std::array<std::array<double, 3>, 6> stops{
        {{0.00, 0.00, 0.01},  // in sRGB, as a screen shows it
         {0.26, 0.04, 0.41},
         {0.58, 0.15, 0.40},
         {0.87, 0.32, 0.23},
         {0.99, 0.65, 0.04},
         {0.99, 1.00, 0.64}}};
    const double place  = std::clamp(share, 0.0, 1.0) * (stops.size() - 1);
    const auto   below  = std::min(std::size_t(place), stops.size() - 2);
    const auto   linear = [&](std::size_t channel) {
        const double mixed = stops[below][channel] +
                             (place - double(below)) * (stops[below + 1][channel] - stops[below][channel]);
        return float(std::pow(mixed, 2.2));
    };
    return {linear(0), linear(1), linear(2)};
}

/// Which numbers of nodes have which colours. They follow the square root of the number: most pixels ask few.
struct NodeScale {
    int most;   ///< from here on, the last colour
    int notch;  ///< of the scale below the picture

    [[nodiscard]] Spectrum operator()(double nodes) const { return heat(std::sqrt(nodes / most)); }
    /// How many nodes stand at a share of the scale's length.
    [[nodiscard]] double   at(double share) const { return most * share * share; }
};

/// The counts as colours, and below them the scale: a bar from 0 to `most`, with its notches.
[[nodiscard]] inline Image<Spectrum> in_colour(const Image<WalkCount>& counts, const NodeScale& scale) {
    const int       width = counts.width(), bar = std::max(8, width / 24);
    Image<Spectrum> film(width, counts.height() + bar);
    for (int y = 0; y < counts.height(); ++y) {
        for (int x = 0; x < width; ++x) film(x, y) = scale(double(counts(x, y).nodes));
    }
    for (int x = 0; x < width; ++x) {
        const double here = scale.at(double(x) / width), next = scale.at(double(x + 1) / width);
        const bool   notched = x > 0 && std::floor(here / scale.notch) < std::floor(next / scale.notch);
        for (int y = 0; y < bar; ++y)
            film(x, counts.height() + y) =
                y < 2 || (notched && y < bar / 2) ? Spectrum{1, 1, 1} : scale(here);
    }
    return film;
}

}  // namespace sr
