#pragma once
/// @file image_error.hpp
/// How wrong a picture is: one measure for all of them.

#include <cstdint>

#include "image/image.hpp"
#include "radiometry/spectrum.hpp"
#include "scene/camera.hpp"
#include "scene/scene.hpp"

namespace sr {

/// Which pixels of a picture count: 1, or 0.
using PixelMask = Image<std::uint8_t>;

/// All pixels but those in which something is seen that shines: a lamp is so bright, and so easily right, that it says
/// nothing about how its light was followed. 4 x 4 rays from border to border of a pixel look for it.
/// @throws std::invalid_argument as check_scene
[[nodiscard]] PixelMask without_emitters(const Scene& scene, const Camera<double>& camera);

/// Relative RMSE: sqrt(mean (I - R)^2) / mean R over all channels of the pixels that count [1]. NaN if none does, or
/// anything in them is.
/// @pre all three are of the same size
[[nodiscard]] double relative_rmse(const Image<Spectrum>& image, const Image<Spectrum>& reference,
                                   const PixelMask& mask);

}  // namespace sr
