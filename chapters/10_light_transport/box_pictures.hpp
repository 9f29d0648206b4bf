#pragma once
/// @file box_pictures.hpp
/// Section 10.7: the Cornell box as both methods see it, and what is between the two.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <vector>

#include "box_by_radiosity.hpp"
#include "course/chapter.hpp"
#include "image/image.hpp"
#include "radiosity/patch_view.hpp"
#include "sampling/sobol_point.hpp"
#include "transport/tiles.hpp"

namespace sr {

/// Points of the box that rays through the middles of pixels meet, and which pixels those are.
struct SeenPoints {
    std::vector<SurfaceSample> points;
    std::vector<Vector2<int>>  pixels;
};

[[nodiscard]] inline SeenPoints seen_points(const BoxByRadiosity& box, const Camera<double>& camera) {
    const Patches   polygons = cut(box.polygons, 1e4);  // longer than any: none is cut
    const PatchView view(polygons);
    SeenPoints      seen;
    for (int y = 0; y < camera.height; ++y)
        for (int x = 0; x < camera.width; ++x)
            if (const auto hit = view.seen(camera.ray_through_pixel(x, y))) {
                seen.points.push_back({hit->position, polygons.shapes[hit->patch].normal(), hit->patch});
                seen.pixels.emplace_back(x, y);
            }
    return seen;
}

/// The radiance that gathering from the solution's links says [W/(m^2 sr)].
[[nodiscard]] inline Image<Spectrum> box_gathered(const BoxByRadiosity& box, const SeenPoints& seen, int side,
                                                  const HierarchicalSolution& solution, int threads) {
    const auto      reflected = box.gathered(seen.points, solution, threads);
    Image<Spectrum> film(side, side);
    for (std::size_t i = 0; i < seen.points.size(); ++i) {
        const auto& emission = box.polygons[seen.points[i].polygon].emission;
        film(seen.pixels[i].x, seen.pixels[i].y) =
            convert<float>((reflected[i] + emission) / std::numbers::pi);
    }
    return film;
}

/// The radiance by so many paths through the middle of each pixel: what both pictures say is then of the same points.
[[nodiscard]] inline Image<Spectrum> paths_through_middles(const BoxByRadiosity& box,
                                                           const Camera<double>& camera, std::uint32_t paths,
                                                           int threads) {
    const auto       rays = convert<float>(camera);
    Image<Spectrum>  film(camera.width, camera.height);
    course::Progress progress("following paths", 1000);
    const TileLoop   loop{.threads = threads, .on_tile = [&](int done, int of) {
                            progress.tick(course::steps_of_part(1000, done, of));
                        }};
    for_each_pixel(camera.width, camera.height, loop, [&](int x, int y) {
        DoubleSpectrum sum;
        PathCount      count;
        for (std::uint32_t i = 0; i < paths; ++i) {
            SobolPoint point(SampleId{.x = x, .y = y, .index = i, .count = paths});
            sum = sum + convert<double>(box.paths.radiance(rays.ray_through_pixel(x, y), point, count));
        }
        film(x, y) = convert<float>(sum / double(paths));
    });
    return film;
}

/// A colour for a difference from -1 to 1, on the screen's scale: blue, white for 0, red.
[[nodiscard]] inline Spectrum signed_colour(double difference) {
    const double d    = std::clamp(difference, -1.0, 1.0);
    const auto   fade = float(std::pow(1 - std::abs(d), 2.2));
    return d < 0 ? Spectrum{fade, fade, 1} : Spectrum{1, fade, fade};
}

/// The green of squares of 4 x 4 pixels, in whose means there is less noise.
[[nodiscard]] inline double green_about(const Image<Spectrum>& film, int x, int y) {
    constexpr int cell = 4;
    double        sum  = 0;
    for (int v = y / cell * cell; v < std::min(film.height(), (y / cell + 1) * cell); ++v)
        for (int u = x / cell * cell; u < std::min(film.width(), (x / cell + 1) * cell); ++u)
            sum += double(film(u, v).g);
    return sum;
}

/// How far the first exceeds the second in green, relative to the second, from -scale to scale. Where nothing is seen,
/// grey; below is a bar from -scale to scale with a notch at each quarter.
[[nodiscard]] inline Image<Spectrum> difference_map(const Image<Spectrum>& first,
                                                    const Image<Spectrum>& second, double scale) {
    const int       side = first.width(), bar = std::max(4, side / 20);
    Image<Spectrum> map(side, side + 2 * bar, {1, 1, 1});
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x) {
            const double a = green_about(first, x, y), b = green_about(second, x, y);
            map(x, y) = b > 0 ? signed_colour((a / b - 1) / scale) : Spectrum{0.2F, 0.2F, 0.2F};
        }
    for (int x = 0; x < side; ++x) {
        const bool notched = x > 0 && 4 * x / side != 4 * (x - 1) / side;
        for (int y = 0; y < bar; ++y)
            map(x, side + bar + y) =
                notched && 2 * y < bar ? Spectrum{} : signed_colour(2 * (x + 0.5) / side - 1);
    }
    return map;
}

[[nodiscard]] inline Image<Spectrum> shown_twice_as_bright(Image<Spectrum> film) {
    for (auto& pixel : film.pixels()) pixel = 2 * pixel;
    return film;
}

inline void render_box_by_both(course::Chapter& chapter, const BoxByRadiosity& box,
                               const HierarchicalSolution& solution) {
    const auto& options = chapter.options();
    const int   side    = 3 * options.size / 4;
    const auto  camera  = cornell_box_camera(side);
    const auto  paths =
        std::uint32_t(course::ByQuality{.draft = 16, .lecture = 64, .print = 576}.at(options.quality));
    Image<Spectrum> by_paths(1, 1), by_radiosity(1, 1);
    const double    of_paths =
        course::seconds_of([&] { by_paths = paths_through_middles(box, camera, paths, options.threads); });
    const double of_gathering = course::seconds_of(
        [&] { by_radiosity = box_gathered(box, seen_points(box, camera), side, solution, options.threads); });
    chapter.render("walls_by_paths", "The Cornell box by paths",
                   fmt::format("{} paths a pixel, shown twice as bright.", paths),
                   shown_twice_as_bright(by_paths));
    chapter.render("walls_by_radiosity", "The Cornell box by radiosity",
                   fmt::format("Gathered from a solution of {} leaves, shown twice as bright.",
                               solution.trees.leaf_count()),
                   shown_twice_as_bright(by_radiosity));
    chapter.render("walls_difference", "Paths less radiosity",
                   "Relative, 4 by 4 pixels together, from -20 % (blue) to 20 % (red); white is 0.",
                   difference_map(by_paths, by_radiosity, 0.2));
    chapter.say(fmt::format("{} paths a pixel {:.2g} s, gathering {:.2g} s", paths, of_paths, of_gathering));
}

}  // namespace sr
