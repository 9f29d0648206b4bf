/// @file image_error.cpp

#include "transport/image_error.hpp"

#include <cmath>
#include <cstddef>

#include "math/square.hpp"
#include "scene/surfaces.hpp"

namespace sr {
namespace {

constexpr int side = 4;  // of the grid of rays, whose outermost lie on the pixel's border

bool sees_emitter(const Scene& scene, const Surfaces<float>& surfaces, const Camera<float>& camera, int x,
                  int y) {
    for (int i = 0; i < side * side; ++i) {
        const Vec2 at  = Vec2{x, y} + Vec2{i % side, i / side} / float(side - 1);
        const auto hit = surfaces.nearest(camera.ray(at));
        if ((hit ? scene.materials[hit->material].emission : scene.background) != Spectrum{}) return true;
    }
    return false;
}

}  // namespace

PixelMask without_emitters(const Scene& scene, const Camera<double>& camera) {
    const Surfaces<float> surfaces(scene);
    const auto            rounded = convert<float>(camera);
    PixelMask             mask(camera.width, camera.height, 1);
    for (int y = 0; y < camera.height; ++y)
        for (int x = 0; x < camera.width; ++x)
            if (sees_emitter(scene, surfaces, rounded, x, y)) mask(x, y) = 0;
    return mask;
}

double relative_rmse(const Image<Spectrum>& image, const Image<Spectrum>& reference, const PixelMask& mask) {
    double squares = 0, sum = 0, count = 0;
    for (std::size_t i = 0; i < mask.pixels().size(); ++i) {
        if (mask.pixels()[i] == 0) continue;
        const Spectrum &I = image.pixels()[i], &R = reference.pixels()[i];
        squares += square(double(I.r - R.r)) + square(double(I.g - R.g)) + square(double(I.b - R.b));
        sum += double(R.r) + double(R.g) + double(R.b);
        count += 3;
    }
    return std::sqrt(squares / count) / (sum / count);
}

}  // namespace sr
