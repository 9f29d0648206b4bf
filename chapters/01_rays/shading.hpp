#pragma once
/// @file shading.hpp
/// Three ways to look at what the rays found, none of which knows of light yet.

#include <algorithm>
#include <cstdint>

#include "geometry/triangle.hpp"
#include "math/interval.hpp"
#include "radiometry/spectrum.hpp"
#include "scene/scene.hpp"
#include "scene/visible.hpp"

namespace sr {

/// A colour for each way to look.
struct Look {
    Spectrum depth{0, 0, 0};       ///< bright is near, black is nothing
    Spectrum normal{1, 1, 1};      ///< -1 to 1 along an axis is 0 to 1 of a primary colour
    Spectrum head_light{1, 1, 1};  ///< equation (1.4)

    /// Adds a share of another look.
    void add(float share, const Look& other) {
        depth      = depth + share * other.depth;
        normal     = normal + share * other.normal;
        head_light = head_light + share * other.head_light;
    }
};

/// Whether a ray of the pixel met a surface: its depth is not black.
[[nodiscard]] inline bool is_something(const Look& pixel) {
    return pixel.depth.r > 0;
}

/// The least and the largest t that is seen.
[[nodiscard]] inline Interval<float> depth_range(const VisibilityImage<float>& visible) {
    Interval<float> range{in_front<float>.max, 0};
    for (const auto& pixel : visible.pixels()) {
        if (!pixel.hit()) continue;
        range.min = std::min(range.min, pixel.t);
        range.max = std::max(range.max, pixel.t);
    }
    return range;
}

/// The unit normal on the side of a triangle that is seen along d. One without area, which rounding to float may
/// give some, has no normal: it faces the viewer.
[[nodiscard]] inline Vector3<double> seen_normal(const Triangle<double>& triangle, Vector3<double> d) {
    const Vector3<double> area = area_vector(triangle);
    const double          size = length(area);
    if (!(size > 0)) return -normalize(d);
    return dot(area, d) > 0 ? -area / size : area / size;
}

/// How a face looks along the direction d, at t.
[[nodiscard]] inline Look look_at(const Scene& scene, std::uint32_t face, Vector3<double> d, float t,
                                  Interval<float> depths) {
    const Vector3<double> n = seen_normal(scene.mesh.triangle(face), d);

    const float nearness =
        std::clamp((depths.max - t) / std::max(depths.max - depths.min, 1e-30F), 0.0F, 1.0F);
    const float grey = 0.03F + 0.87F * nearness * nearness;
    const Vec3  rgb  = (n + 1.0) / 2.0;
    // (1.4) the light is where the eye is: the surface is lit from where it is seen.
    const auto  cosine = float(-dot(n, d) / length(d));
    return {{grey, grey, grey},
            {rgb.x, rgb.y, rgb.z},
            cosine * scene.materials[scene.material_of_face[face]].reflectance()};
}

}  // namespace sr
