#pragma once
/// @file spheres.hpp
/// Section 6.10: a sphere of each material, on a checkered floor under a clear sky.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

#include <glm/common.hpp>

#include "course/chapter.hpp"
#include "geometry/plane.hpp"
#include "geometry/sphere.hpp"
#include "material/checker.hpp"
#include "material/lobe_sum.hpp"
#include "sampling/rng.hpp"
#include "scene/camera.hpp"
#include "skies.hpp"
#include "transport/interaction.hpp"
#include "transport/render.hpp"
#include "transport/tiles.hpp"

namespace sr {

/// The unit spheres of the picture, in two rows of three, and the floor z = 0.
class Spheres {
public:
    /// Where a ray meets something, what that is made of, and the colour that a texture gives it there, 0 to 1.
    struct Hit {
        SurfacePoint<float>   point;
        const LobeSum<float>& material;
        Spectrum              texture;
    };

    Spheres() {
        const Spectrum white{0.9F, 0.9F, 0.9F}, blue{0.06F, 0.22F, 0.55F}, grey{0.35F, 0.35F, 0.35F};
        add({{{0.75F, 0.42F, 0.16F}, Diffuse<float>{}}});
        add({{{1, 1, 1}, Diffuse<float>{}}});  // coloured where it is hit
        add({{{0.95F, 0.72F, 0.40F}, Phong{30.0F}}});
        add({{blue, Diffuse<float>{}}, {grey, Phong{400.0F}}});
        add({{white, Mirror<float>{}}});
        add({{{1, 1, 1}, Dielectric{1.5F}}});
    }

    [[nodiscard]] std::optional<Hit> nearest(const Ray<float>& ray) const {
        std::optional<float> t = intersect(floor_, ray);
        std::size_t          i = spheres_.size();
        for (std::size_t s = 0; s < spheres_.size(); ++s) {
            const auto near = intersect(spheres_[s], ray);
            if (!near || (t && !(*near < *t))) continue;
            t = near;
            i = s;
        }
        if (!t) return std::nullopt;
        if (i == spheres_.size()) {
            const auto point = surface_point(floor_, ray, *t);
            const Vec2 middle{0.5F, 0.5F};  // no edge of a tile cuts the picture in two
            return Hit{point, stone_, tiles_(Vec2{point.position} / tile_side + middle)};
        }
        const auto     point = surface_point(spheres_[i], ray, *t);
        const Spectrum plain{1, 1, 1};
        return Hit{point, materials_[i], i == 1 ? globe_(longitude_latitude(point.normal)) : plain};
    }

private:
    void add(std::vector<WeightedLobe<float>> lobes) {
        const std::size_t column = spheres_.size() % 3, row = spheres_.size() / 3;
        spheres_.push_back({{2.7F * (float(column) - 1), -3.4F * float(row), above_floor}, 1});
        materials_.emplace_back(std::move(lobes));
    }

    /// In squares of 22.5 degrees.
    [[nodiscard]] static Vec2 longitude_latitude(const Vec3& n) {
        constexpr float per_radian = 8 / std::numbers::pi_v<float>;
        return {per_radian * std::atan2(n.y, n.x), per_radian * std::asin(n.z)};
    }

    static constexpr float above_floor =
        1.002F;  // where they touched, light in glass could get below the floor
    static constexpr float tile_side = 1.8F;

    Plane<float>                floor_{{0, 0, 0}, {0, 0, 1}};
    Checker                     tiles_{{0.58F, 0.56F, 0.53F}, {0.40F, 0.40F, 0.41F}};
    Checker                     globe_{{0.80F, 0.80F, 0.76F}, {0.10F, 0.35F, 0.22F}};
    LobeSum<float>              stone_{{{{1, 1, 1}, Diffuse<float>{}}}};
    std::vector<Sphere<float>>  spheres_;
    std::vector<LobeSum<float>> materials_;
};

/// Radiance along a ray: surfaces draw where it comes from until it comes from the sky. Chapter 7 says why this works.
/// @param first  what draws the first of these directions
[[nodiscard]] inline Spectrum radiance(const Spheres& spheres, const ClearSky& sky, Ray<float> ray,
                                       Vec2 first, Rng& rng) {
    constexpr int  longest = 24;  // what bounces more often counts next to nothing
    const Spectrum blue{0.86F, 0.97F, 1.20F};
    Spectrum       throughput{1, 1, 1};
    for (int bounce = 0; bounce < longest; ++bounce) {
        const auto hit = spheres.nearest(ray);
        if (!hit) return float(sky(Vector3<double>(ray.direction))) * (throughput * blue);
        const Interaction<float> at(hit->point, ray.direction, Sides::two);
        const float              u = rng.uniform(), v = rng.uniform();
        const Vec2               draw = bounce == 0 ? first : Vec2{u, v};
        const auto               next = hit->material.sample(at.wo(), draw, TransportMode::radiance);
        if (!next) return {};
        throughput = throughput * hit->texture * next->weight;
        ray        = at.leave(next->wi);
    }
    return {};
}

/// The n-th of a sequence of points that keep away from each other: less noise than chance.
/// @see Roberts, The Unreasonable Effectiveness of Quasirandom Sequences (2018)
[[nodiscard]] inline Vec2 spread_point(int n) {
    const Vec2 p = 0.5F + float(n) * Vec2{0.75487767F, 0.56984029F};
    return p - glm::floor(p);
}

/// Mean radiance of a pixel. A sample has the same random numbers in all pixels, so that neighbours err alike and no
/// grain is seen: it is a picture to look at, no measurement.
[[nodiscard]] inline Spectrum pixel_of(const Spheres& spheres, const ClearSky& sky,
                                       const Camera<float>& camera, int x, int y,
                                       const PixelSampling& sampling) {
    const int side = grid_side(sampling.samples);
    Spectrum  sum;
    for (int sample = 0; sample < sampling.samples; ++sample) {
        Rng        rng{sampling.seed, 0, 0, sample};
        const int  column = sample % side, row = sample / side;
        const Vec2 cell{float(column), float(row)};
        Ray<float> ray   = camera.ray(Vec2(float(x), float(y)) + (cell + 0.5F) / float(side));
        ray.direction    = normalize(ray.direction);
        const Spectrum L = radiance(spheres, sky, ray, spread_point(sample), rng);
        if (!each_in(L, 0, std::numeric_limits<float>::max())) throw BadSample(x, y, sample, L);
        sum = sum + L;
    }
    return 1 / float(sampling.samples) * sum;
}

inline void render_spheres(course::Chapter& chapter) {
    const auto& options = chapter.options();
    const int   width   = options.size * 7 / 8;  // at most 150 kB: the text shows it
    const int   height  = std::max(16, width * 11 / 20);
    const auto  camera  = convert<float>(
        pinhole_camera<double>({0, -13, 8.5}, {0, 11.3, -7.7}, {0, 0, 1}, 1.0, 0.66, width, height));
    const ClearSky   sky{normalize(Vector3<double>{-0.65, -0.75, 0.9})};
    const Spheres    spheres;
    Image<Spectrum>  film(width, height);
    course::Progress progress{"a sphere of each material", height};
    for_each_pixel(width, height, {.threads = options.threads}, [&](int x, int y) {
        film(x, y) = 0.42F * pixel_of(spheres, sky, camera, x, y, {options.samples, options.seed});
        if (x == 0) progress.tick();
    });
    chapter.render(
        "spheres", "A sphere of each material",
        "Behind, from the left: diffuse, checkered, Phong's lobe of exponent 30; in front: diffuse "
        "below Phong's lobe, mirror, glass. Under the CIE's clear sky.",
        film);
}

}  // namespace sr
