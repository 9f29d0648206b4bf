#pragma once
/// @file write_image.hpp
/// A render leaves as two files: a PNG to look at, and an HDR that keeps the numbers.

#include <filesystem>

#include "image/image.hpp"
#include "radiometry/spectrum.hpp"

namespace sr {

/// Writes the picture with 8 bits a channel: linear radiance is clamped to [0, 1] and passed through the
/// transfer function of sRGB (IEC 61966-2-1).
/// @throws std::runtime_error if a pixel is not finite (the message names it) or the file can't be written
void write_png(const std::filesystem::path& path, const Image<Spectrum>& image);

/// Writes the linear values as Radiance RGBE: three mantissas of 8 bits and an exponent in common, so that
/// a channel is right to 1/128 of the pixel's largest (Ward, Real Pixels, Graphics Gems II, 1991).
/// @throws std::runtime_error if a pixel is negative, not finite or above the format's range (the message
///         names it), or the file can't be written
void write_hdr(const std::filesystem::path& path, const Image<Spectrum>& image);

}  // namespace sr
