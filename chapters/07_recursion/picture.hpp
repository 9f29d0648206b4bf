#pragma once
/// @file picture.hpp
/// A scene as the recursive tracer shows it, and how many rays that took.

#include "course/chapter.hpp"
#include "scene/scene_view.hpp"
#include "transport/recursion.hpp"
#include "transport/render.hpp"
#include "transport/tiles.hpp"

namespace sr {

/// What a progress counts for a picture.
inline constexpr int steps_of_picture = 1000;

/// A loop over a picture that tells a progress how far it is.
[[nodiscard]] inline TileLoop told_to(course::Progress& progress, int threads) {
    return {.threads = threads, .on_tile = [&](int done, int of) {
                progress.tick(course::steps_of_part(steps_of_picture, done, of));
            }};
}

[[nodiscard]] inline Image<Spectrum> picture(const SceneView& view, const RecursionOptions& recursion,
                                             const course::Options& options, course::Progress& progress) {
    const RecursiveTracer tracer(view.scene, recursion);
    return render(convert<float>(view.camera), {.samples = options.samples, .seed = options.seed},
                  told_to(progress, options.threads), [&](const Ray<float>& ray, Rng& rng) {
                      RayCount count;
                      return tracer.radiance(ray, rng, count);
                  });
}

/// What a picture lacks of another one that has all of it, ten times as bright.
[[nodiscard]] inline Image<Spectrum> lacking(const Image<Spectrum>& picture, const Image<Spectrum>& all) {
    Image<Spectrum> difference(all.width(), all.height());
    for (int y = 0; y < all.height(); ++y)
        for (int x = 0; x < all.width(); ++x) difference(x, y) = 10 * (all(x, y) - picture(x, y));
    return difference;
}

/// The rays of an image with one through the middle of each pixel.
[[nodiscard]] inline RayCount count_rays(const SceneView& view, const RecursionOptions& recursion,
                                         int threads) {
    const RecursiveTracer tracer(view.scene, recursion);
    const auto            camera = convert<float>(view.camera);
    Image<RayCount>       counts(camera.width, camera.height);
    for_each_pixel(camera.width, camera.height, {.threads = threads}, [&](int x, int y) {
        Rng rng{1, x, y, 0};
        (void)tracer.radiance(camera.ray_through_pixel(x, y), rng, counts(x, y));
    });
    RayCount sum;
    for (const auto& count : counts.pixels()) sum += count;
    return sum;
}

}  // namespace sr
