#pragma once
/// @file traced.hpp
/// A picture by random paths, in one call.
///
///     const SampledImage image = traced(scene, camera, {.strategy = Strategy::power}, {.samples = 64}, loop);
///     write(image.mean());

#include "sampling/sobol_point.hpp"
#include "transport/path_tracer.hpp"
#include "transport/sampled_image.hpp"
#include "transport/tiles.hpp"

namespace sr {

/// @param passes  each of them of pass.samples a pixel: the image knows its error from two passes on
/// @param loop    is told of the tiles of each pass
/// @tparam P      RandomPoint, StratifiedPoint, HaltonPoint or SobolPoint
/// @throws std::invalid_argument as PathTracer; BadSample
template <SamplePoint P = SobolPoint>
[[nodiscard]] SampledImage traced(const Scene& scene, const Camera<double>& camera, const PathOptions& paths,
                                  const PassOptions& pass, const TileLoop& loop, int passes = 1) {
    const PathTracer tracer(scene, paths);
    SampledImage     image(convert<float>(camera), pass);
    for (int i = 0; i < passes; ++i)
        image.add_pass<P>(loop, [&](const Ray<float>& ray, P& point) {
            PathCount count;
            return tracer.radiance(ray, point, count);
        });
    return image;
}

}  // namespace sr
