#pragma once
/// @file race.hpp
/// Rasteriser and ray tracer against the clock, one thread each, on the teapot at any fineness.

#include <algorithm>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "course/timing.hpp"
#include "geometry/hierarchy.hpp"
#include "sampling/rng.hpp"
#include "scene/rasteriser.hpp"
#include "scenes.hpp"
#include "statistics/estimate.hpp"
#include "transport/primary.hpp"
#include "wrong_pixels.hpp"

namespace sr {

/// Seconds for a whole image, and the share of pixels that name another triangle than a rasteriser in double.
struct Lap {
    std::string method;
    double      seconds, slowest;
    double      error, error_se;
};

/// One image of the teapot, ready to be made by each method.
class Race {
public:
    Race(int level, int side)
        : exact_(teapot(level)),
          mesh_(convert<float>(exact_)),
          exact_camera_(teapot_camera(side, side)),
          camera_(convert<float>(exact_camera_)) {}

    [[nodiscard]] std::size_t triangles() const { return mesh_.faces.size(); }
    [[nodiscard]] int         pixels() const { return camera_.width * camera_.height; }

    /// All methods, in turn, `repeats` times. Asking all triangles is timed on so many random pixels that
    /// it takes about `tests` ray-triangle tests, and scaled to the whole image.
    [[nodiscard]] std::vector<Lap> run(int repeats, double tests, std::uint64_t seed) const {
        const double sampled = std::max(tests / double(triangles()), 16.0);
        const auto   every   = every_pixel(camera_.width, camera_.height);
        const auto   some    = sampled < double(pixels()) ? random_pixels(int(sampled), seed) : every;

        VisibilityImage<float>          raster(1, 1), traced(1, 1), asked(camera_.width, camera_.height);
        std::optional<Hierarchy<float>> hierarchy;
        const BruteForce<float>         all(mesh_);
        const auto                      timings =
            course::measure({{"rasteriser", [&] { raster = rasterise(mesh_, camera_); }},
                             {"rays, all triangles",
                              [&] {
                                  for (const auto& p : some) see(all, p, asked);
                              }},
                             {"build", [&] { hierarchy.emplace(mesh_); }},
                             {"rays, hierarchy", [&] { traced = trace_primary(*hierarchy, camera_); }}},
                            repeats);

        return {lap(timings[0], 1, raster, every),
                lap(timings[1], double(pixels()) / double(some.size()), asked, some),
                lap(timings[3], 1, traced, every), with_build(timings[2], lap(timings[3], 1, traced, every))};
    }

private:
    void see(const BruteForce<float>& all, Pixel p, VisibilityImage<float>& image) const {
        const auto hit  = all.nearest(camera_.ray_through_pixel(p.x, p.y));
        image(p.x, p.y) = hit ? Visible<float>{hit->t, hit->face} : Visible<float>{};
    }

    [[nodiscard]] std::vector<Pixel> random_pixels(int count, std::uint64_t seed) const {
        std::vector<Pixel> result;
        for (int i = 0; i < count; ++i) {
            Rng       rng{seed, 0, 0, i};
            const int x = int(rng.uniform() * float(camera_.width));
            const int y = int(rng.uniform() * float(camera_.height));
            result.push_back({x, y});
        }
        return result;
    }

    [[nodiscard]] Lap lap(const course::Timing& timing, double scale, const VisibilityImage<float>& image,
                          const std::vector<Pixel>& where) const {
        const Estimate wrong = share(wrong_pixels(image, reference_, where), where.size());
        const bool     all   = where.size() == image.pixels().size();  // which leaves nothing to chance
        return {timing.name, timing.seconds * scale, timing.slowest * scale, wrong.value,
                all ? 0 : wrong.error};
    }

    [[nodiscard]] static Lap with_build(const course::Timing& build, Lap traced) {
        traced.method = "rays, hierarchy and its building";
        traced.seconds += build.seconds;
        traced.slowest += build.slowest;
        return traced;
    }

    Mesh<double>            exact_;
    Mesh<float>             mesh_;
    Camera<double>          exact_camera_;
    Camera<float>           camera_;
    VisibilityImage<double> reference_ = rasterise(exact_, exact_camera_);
};

}  // namespace sr
