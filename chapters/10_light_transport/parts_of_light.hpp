#pragma once
/// @file parts_of_light.hpp
/// Section 10.5: a picture in parts, by the ways that their light took.

#include <array>
#include <cstddef>
#include <cstdint>
#include <regex>
#include <string>
#include <string_view>
#include <unordered_map>

#include "image/image.hpp"
#include "scene/scene_view.hpp"
#include "statistics/running.hpp"
#include "transport/path_tracer.hpp"
#include "transport/tiles.hpp"

namespace sr {

/// Light of one kind: all ways that match an expression, and none before it.
struct PartOfLight {
    std::string_view name;
    std::string_view ways;
};

inline constexpr std::array parts_of_light{
    PartOfLight{"the lamp", "LE"},           PartOfLight{"its images", "LS+E"},
    PartOfLight{"direct light", "LDE"},      PartOfLight{"interreflection", "LDD+E"},
    PartOfLight{"images of both", "LD+S+E"}, PartOfLight{"caustics", "LS+DE"},
    PartOfLight{"all other", "L[DS]*E"},
};

/// Which part a way belongs to. Expressions are slow, and the same ways come again and again: each thread remembers.
[[nodiscard]] inline std::size_t part_of(std::string_view way) {
    thread_local std::unordered_map<std::string, std::size_t> known;
    const auto [at, is_new] = known.try_emplace(std::string(way));
    if (is_new) {
        // the first expression that the way matches
        while (!std::regex_match(at->first, std::regex(std::string(parts_of_light[at->second].ways))))
            ++at->second;
    }
    return at->second;
}

/// What one pixel gets, part by part: the sum over samples, and the mean of the channels of each sample.
struct PixelParts {
    std::array<DoubleSpectrum, parts_of_light.size()> sum;
    std::array<Running, parts_of_light.size()>        brightness;
};

/// @param seed  those of different ones are independent
/// @tparam P    RandomPoint or SobolPoint
template <SamplePoint P>
[[nodiscard]] Image<PixelParts> picture_in_parts(const SceneView& view, Strategy strategy, std::uint64_t seed,
                                                 std::uint32_t samples, const TileLoop& loop) {
    const PathTracer  tracer(view.scene, {.strategy = strategy});
    const auto        camera = convert<float>(view.camera);
    Image<PixelParts> picture(camera.width, camera.height);
    for_each_pixel(camera.width, camera.height, loop, [&](int x, int y) {
        auto& pixel = picture(x, y);
        for (std::uint32_t i = 0; i < samples; ++i) {
            P                                                 point(SampleId{seed, x, y, i, samples});
            const Vec2                                        at = Vec2{x, y} + point.template pair<float>();
            PathCount                                         count;
            // light that the sample finds, sorted by its way
            std::array<DoubleSpectrum, parts_of_light.size()> found;
            tracer.each_light(camera.ray(at), point, count, [&](std::string_view way, Spectrum L) {
                auto& part = found[part_of(way)];
                part       = part + convert<double>(L);
            });
            for (std::size_t k = 0; k < found.size(); ++k) {
                pixel.sum[k] = pixel.sum[k] + found[k];
                pixel.brightness[k].add(mean(found[k]));
            }
        }
    });
    return picture;
}

}  // namespace sr
