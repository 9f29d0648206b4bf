/// @file write_image.cpp

#include "image/write_image.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "image/whole_file.hpp"

#define STB_IMAGE_WRITE_IMPLEMENTATION
#include <stb_image_write.h>

namespace sr {
namespace {

/// Calls keep(channel) for every channel of every pixel that `good` accepts.
/// @throws std::runtime_error that names the first pixel which it doesn't
template <class Good, class Keep>
void for_each_channel(const std::filesystem::path& path, const Image<Spectrum>& image, const char* rule,
                      Good good, Keep keep) {
    for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x) {
            const Spectrum s = image(x, y);
            if (!(good(s.r) && good(s.g) && good(s.b))) {
                throw std::runtime_error(fmt::format("{}: pixel ({}, {}) is ({}, {}, {}): must be {}",
                                                     path.string(), x, y, s.r, s.g, s.b, rule));
            }
            keep(s.r);
            keep(s.g);
            keep(s.b);
        }
    }
}

/// Transfer function of sRGB (IEC 61966-2-1), to 8 bits.
std::uint8_t to_srgb(float linear) {
    const double v       = std::clamp(double(linear), 0.0, 1.0);
    const double encoded = v <= 0.0031308 ? 12.92 * v : 1.055 * std::pow(v, 1 / 2.4) - 0.055;
    return std::uint8_t(std::lround(255 * encoded));
}

/// What stb hands over piece by piece; it can't tell of a full disk, so the file is ours to write.
void append(void* bytes, void* data, int size) {
    static_cast<std::string*>(bytes)->append(static_cast<const char*>(data), std::size_t(size));
}

void write_encoded(const std::filesystem::path& path, int success, const std::string& bytes) {
    if (success == 0) throw std::runtime_error(path.string() + ": not enough memory to encode the image");
    write_whole_file(path, bytes);
}

}  // namespace

void write_png(const std::filesystem::path& path, const Image<Spectrum>& image) {
    std::vector<std::uint8_t> channels;
    channels.reserve(3 * image.pixels().size());
    for_each_channel(
        path, image, "finite", [](float v) { return std::isfinite(v); },
        [&](float v) { channels.push_back(to_srgb(v)); });

    std::string bytes;
    const int   success = stbi_write_png_to_func(append, &bytes, image.width(), image.height(), 3,
                                                 channels.data(), 3 * image.width());
    write_encoded(path, success, bytes);
}

void write_hdr(const std::filesystem::path& path, const Image<Spectrum>& image) {
    std::vector<float> channels;
    channels.reserve(3 * image.pixels().size());
    for_each_channel(
        path, image, "0 or more and below 2^127", [](float v) { return v >= 0 && v < 0x1p127F; },
        [&](float v) { channels.push_back(v); });

    std::string bytes;
    const int   success =
        stbi_write_hdr_to_func(append, &bytes, image.width(), image.height(), 3, channels.data());
    write_encoded(path, success, bytes);
}

}  // namespace sr
