/// @file image.cpp

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <stdexcept>
#include <string>

#include "image/image.hpp"
#include "image/write_image.hpp"
#include "math/extremes.hpp"
#include "scratch_folder.hpp"

#define STB_IMAGE_IMPLEMENTATION
#include <stb_image.h>

using namespace sr;
using sr::test::ScratchFolder;

namespace {

/// What the writer says to the picture, "" if it has nothing to say.
template <class Write>
std::string complaint(Write write, const std::filesystem::path& path, const Image<Spectrum>& image) {
    try {
        write(path, image);
    } catch (const std::runtime_error& error) {
        return error.what();
    }
    return "";
}

}  // namespace

TEST_CASE("image: row after row from the top left corner") {
    Image<int> image(3, 2);
    image(2, 0) = 7;
    image(0, 1) = 8;
    CHECK(image.width() == 3);
    CHECK(image.height() == 2);
    CHECK(image.pixels().size() == 6);
    CHECK(image.pixels()[2] == 7);
    CHECK(image.pixels()[3] == 8);
    CHECK(image == image);
    CHECK(image != Image<int>(3, 2, 5));
}

TEST_CASE("image: a side of no pixels, or of too many, is refused") {
    CHECK_THROWS_AS(Image<int>(0, 1), std::invalid_argument);
    CHECK_THROWS_AS(Image<int>(1, -1), std::invalid_argument);
    CHECK_THROWS_WITH(Image<int>(100'000, 1), "image width 100000: must be 1 to 16384 pixels");
}

TEST_CASE("png: sRGB's transfer function, clamped, and each channel and pixel in its place") {
    const ScratchFolder folder("image_test");
    const auto          path = folder.path / "a.png";
    Image<Spectrum>     image(3, 2);
    image(0, 0) = {0, 1, 0.5F};
    image(1, 0) = {0.18F, 0.0031308F, 0.001F};  // middle grey; the end of the straight piece; on it
    image(2, 0) = {-1, 2, 1e30F};               // clamped
    image(0, 1) = {0.725F, 0.065F, 0.05F};
    write_png(path, image);

    int            width = 0, height = 0, channels = 0;
    unsigned char* pixels = stbi_load(path.string().c_str(), &width, &height, &channels, 0);
    REQUIRE(pixels != nullptr);
    CHECK(width == 3);
    CHECK(height == 2);
    CHECK(channels == 3);
    // 255 (1.055 v^(1/2.4) - 0.055) by another program, rounded
    const int expected[] = {0, 255, 188, 118, 10, 3, 0, 255, 255, 221, 72, 63, 0, 0, 0, 0, 0, 0};
    for (int i = 0; i < 18; ++i) {
        CAPTURE(i);
        CHECK(int{pixels[i]} == expected[i]);
    }
    stbi_image_free(pixels);
}

TEST_CASE("hdr: three mantissas and one exponent, decoded by hand") {
    const ScratchFolder folder("image_test");
    const auto          path = folder.path / "a.hdr";
    Image<Spectrum>     image(2, 2);
    image(0, 0) = {1, 0.5F, 0.25F};
    image(1, 0) = {0, 0, 0};
    image(0, 1) = {17, 12, 4};
    image(1, 1) = {1e-20F, 3e37F, 1e30F};
    write_hdr(path, image);

    const std::string bytes  = test::read_text(path);
    const std::string header = "-Y 2 +X 2\n";
    CHECK(bytes.starts_with("#?RADIANCE\n"));
    const std::size_t start = bytes.find(header) + header.size();
    REQUIRE(bytes.size() == start + std::size_t{16});
    for (std::size_t i = 0; i < 4; ++i) {
        CAPTURE(i);
        const auto byte = [&](std::size_t k) { return static_cast<unsigned char>(bytes[start + 4 * i + k]); };
        const double unit    = byte(3) == 0 ? 0 : std::ldexp(1.0, byte(3) - 136);
        const auto   s       = image.pixels()[i];
        const double largest = double(std::max({s.r, s.g, s.b}));
        CHECK(std::abs(unit * byte(0) - double(s.r)) <= largest / 128);
        CHECK(std::abs(unit * byte(1) - double(s.g)) <= largest / 128);
        CHECK(std::abs(unit * byte(2) - double(s.b)) <= largest / 128);
    }
}

TEST_CASE("hdr: a wide image, whose rows are run-length encoded, and the same bytes each time") {
    const ScratchFolder folder("image_test");
    const auto          path = folder.path / "wide.hdr";
    Image<Spectrum>     image(300, 3);
    for (int y = 0; y < 3; ++y) {
        for (int x = 0; x < 300; ++x) image(x, y) = {x < 200 ? 1.0F : float(x), float(y), 2};
    }
    write_hdr(path, image);
    const std::string first = test::read_text(path);
    write_hdr(path, image);
    CHECK(test::read_text(path) == first);

    int    width = 0, height = 0, channels = 0;
    float* pixels = stbi_loadf(path.string().c_str(), &width, &height, &channels, 3);
    REQUIRE(pixels != nullptr);
    REQUIRE(width == 300);
    REQUIRE(height == 3);
    float worst = 0;
    for (std::size_t i = 0; i < 900; ++i) {
        const Spectrum s      = image.pixels()[i];
        const float    sent[] = {s.r, s.g, s.b}, largest = std::max({s.r, s.g, s.b});
        for (std::size_t k = 0; k < 3; ++k)
            worst = max_or_nan(worst, std::abs(pixels[3 * i + k] - sent[k]) / largest);
    }
    CHECK(worst <= 1.0F / 128);
    stbi_image_free(pixels);
}

TEST_CASE("a pixel that no format can hold is named, and nothing is written") {
    const float         nan = std::numeric_limits<float>::quiet_NaN();
    const float         inf = std::numeric_limits<float>::infinity();
    const ScratchFolder folder("image_test");
    const auto          path = folder.path / "bad.any";
    Image<Spectrum>     image(4, 3, {1, 1, 1});

    image(3, 2) = {0, nan, 0};
    CHECK(complaint(write_png, path, image).find("pixel (3, 2) is (0, nan, 0): must be finite") !=
          std::string::npos);
    CHECK(complaint(write_hdr, path, image).find("pixel (3, 2) is (0, nan, 0): must be 0 or more") !=
          std::string::npos);
    image(3, 2) = {0, 0, -inf};
    CHECK(complaint(write_png, path, image).find("pixel (3, 2)") != std::string::npos);
    CHECK(complaint(write_hdr, path, image).find("pixel (3, 2)") != std::string::npos);
    image(3, 2) = {-1e-6F, 0, 3e38F};
    CHECK(complaint(write_hdr, path, image).find("pixel (3, 2)") != std::string::npos);
    CHECK(folder.files() == 0);
    CHECK(complaint(write_png, path, image) == "");
    CHECK(folder.files() == 1);
}
