#pragma once
/// @file picture.hpp
/// A scene as the recursive tracer shows it, and how many rays that took.

#include <string>

#include "course/chapter.hpp"
#include "scene/scene_view.hpp"
#include "transport/recursion.hpp"
#include "transport/render.hpp"

namespace sr {

[[nodiscard]] inline Image<Spectrum> picture(const SceneView& view, const RecursionOptions& recursion,
                                             const course::Options& options, const std::string& name) {
    const RecursiveTracer tracer(view.scene, recursion);
    course::Progress      progress("tracing " + name, 1000);
    const auto on_tile = [&](int done, int of) { progress.tick(1000 * done / of - 1000 * (done - 1) / of); };
    return render(convert<float>(view.camera), {.samples = options.samples, .seed = options.seed},
                  {.threads = options.threads, .on_tile = on_tile}, [&](const Ray<float>& ray, Rng& rng) {
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
