#pragma once
/// @file image.hpp

#include <cstddef>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

namespace sr {

/// A rectangle of pixels, row after row from the top left corner; x counts to the right and y downwards.
template <class Pixel>
class Image {
public:
    /// The longest side that the file formats' writer can count the bytes of.
    static constexpr int max_side = 16384;

    /// @throws std::invalid_argument unless both sides are 1 to max_side pixels
    Image(int width, int height, Pixel fill = {})
        : width_{checked("width", width)},
          height_{checked("height", height)},
          pixels_(count(width, height), fill) {}

    [[nodiscard]] int width() const { return width_; }
    [[nodiscard]] int height() const { return height_; }

    /// @pre 0 <= x < width() and 0 <= y < height()
    [[nodiscard]] Pixel&       operator()(int x, int y) { return pixels_[index(x, y)]; }
    [[nodiscard]] const Pixel& operator()(int x, int y) const { return pixels_[index(x, y)]; }

    [[nodiscard]] std::span<Pixel>       pixels() { return pixels_; }
    [[nodiscard]] std::span<const Pixel> pixels() const { return pixels_; }

    friend bool operator==(const Image&, const Image&) = default;

private:
    static int checked(const char* side, int size) {
        if (size >= 1 && size <= max_side) return size;
        throw std::invalid_argument("image " + std::string(side) + " " + std::to_string(size) +
                                    ": must be 1 to " + std::to_string(max_side) + " pixels");
    }
    static std::size_t count(int width, int height) { return std::size_t(width) * std::size_t(height); }
    [[nodiscard]] std::size_t index(int x, int y) const {
        return std::size_t(y) * std::size_t(width_) + std::size_t(x);
    }

    int                width_;
    int                height_;
    std::vector<Pixel> pixels_;
};

}  // namespace sr
