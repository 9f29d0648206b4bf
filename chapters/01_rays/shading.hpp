#pragma once
/// @file shading.hpp
/// Three ways to look at what the rays found, none of which knows of light yet.

#include <algorithm>
#include <cmath>
#include <limits>

#include "image/image.hpp"
#include "radiometry/spectrum.hpp"
#include "scene/camera.hpp"
#include "scene/scene.hpp"
#include "scene/visible.hpp"

namespace sr {

enum class Shading { depth, normal, head_light };

/// What a picture is shaded from: a scene, its camera, and what each pixel sees.
struct View {
    const Scene&                  scene;
    const Camera<float>&          camera;
    const VisibilityImage<float>& visible;
};

/// The least and the largest t that is seen.
[[nodiscard]] inline Interval<float> depth_range(const VisibilityImage<float>& visible) {
    Interval<float> range{std::numeric_limits<float>::infinity(), 0};
    for (const auto& pixel : visible.pixels()) {
        if (!pixel.hit()) continue;
        range.min = std::min(range.min, pixel.t);
        range.max = std::max(range.max, pixel.t);
    }
    return range;
}

/// The face's normal, turned to the side that the ray comes from.
[[nodiscard]] inline Vec3 normal_towards(const Scene& scene, std::uint32_t face, Vec3 d) {
    const Vec3 n = normalize(area_vector(scene.mesh.triangle(face)));
    return dot(n, d) < 0 ? n : -n;
}

/// Colours every pixel: its depth from near (bright) to far, its normal with -1..1 of an axis as 0..1 of a
/// primary, or the head light, equation (1.4). White where nothing is seen.
[[nodiscard]] inline Image<Spectrum> shade(const View& view, Shading shading) {
    const Interval<float> depth = depth_range(view.visible);
    Image<Spectrum>       film(view.camera.width, view.camera.height, {1, 1, 1});
    for (int y = 0; y < film.height(); ++y) {
        for (int x = 0; x < film.width(); ++x) {
            const Visible<float> pixel = view.visible(x, y);
            if (!pixel.hit()) continue;
            const Vec3 d = view.camera.ray_through_pixel(x, y).direction;
            const Vec3 n = normal_towards(view.scene, pixel.face, d);
            switch (shading) {
                case Shading::depth: {
                    const float nearness = (depth.max - pixel.t) / std::max(depth.max - depth.min, 1e-30F);
                    const float grey     = 0.03F + 0.67F * nearness * nearness;
                    film(x, y)           = {grey, grey, grey};
                    break;
                }
                case Shading::normal:
                    film(x, y) = {(n.x + 1) / 2, (n.y + 1) / 2, (n.z + 1) / 2};
                    break;
                case Shading::head_light: {
                    // (1.4) the light is where the eye is, so both see the surface under the same angle.
                    const float cosine = -dot(n, d) / length(d);
                    film(x, y) =
                        cosine * view.scene.materials[view.scene.material_of_face[pixel.face]].reflectance;
                    break;
                }
            }
        }
    }
    return film;
}

/// The mean of factor x factor pixels as one: a pixel is a square and not a point.
[[nodiscard]] inline Image<Spectrum> averaged(const Image<Spectrum>& fine, int factor) {
    Image<Spectrum> film(fine.width() / factor, fine.height() / factor);
    for (int y = 0; y < fine.height(); ++y) {
        for (int x = 0; x < fine.width(); ++x) {
            auto& sum = film(x / factor, y / factor);
            sum       = sum + 1.0F / float(factor * factor) * fine(x, y);
        }
    }
    return film;
}

}  // namespace sr
