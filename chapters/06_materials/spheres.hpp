#pragma once
/// @file spheres.hpp
/// Section 6.10: a sphere of each material in a row, on a checkered floor under a clear sky.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <stdexcept>
#include <utility>
#include <vector>

#include <glm/common.hpp>

#include "course/chapter.hpp"
#include "geometry/offset.hpp"
#include "geometry/plane.hpp"
#include "geometry/sphere.hpp"
#include "material/checker.hpp"
#include "material/lobe_sum.hpp"
#include "math/frame.hpp"
#include "reflected.hpp"
#include "sampling/rng.hpp"
#include "scene/camera.hpp"
#include "skies.hpp"
#include "transport/tiles.hpp"

namespace sr {

using Material = LobeSum<float>;

[[nodiscard]] inline Material one_lobe(Spectrum weight, const Lobe<float>& lobe) {
    return Material{{{weight, lobe}}};
}

/// The unit spheres of the picture, from left to right, and the floor z = 0.
class SphereRow {
public:
    /// Where a ray meets something, and what that is made of.
    struct Hit {
        SurfacePoint<float> point;
        Material            material;
    };

    SphereRow() {
        const Spectrum white{0.9F, 0.9F, 0.9F};
        add(one_lobe({0.75F, 0.42F, 0.16F}, Diffuse<float>{}));
        add(one_lobe(white, Diffuse<float>{}));  // checkered where it is hit
        add(one_lobe({0.95F, 0.72F, 0.40F}, Phong{30.0F}));
        add(Material{{{{0.06F, 0.22F, 0.55F}, Diffuse<float>{}}, {{0.35F, 0.35F, 0.35F}, Phong{400.0F}}}});
        add(one_lobe(white, Mirror<float>{}));
        add(one_lobe({1, 1, 1}, Dielectric{1.5F}));
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
        if (i < spheres_.size()) {
            const auto point = surface_point(spheres_[i], ray, *t);
            return Hit{point, i == 1 ? one_lobe(globe_(longitude_latitude(point.normal)), Diffuse<float>{})
                                     : materials_[i]};
        }
        const auto point = surface_point(floor_, ray, *t);
        return Hit{point,
                   one_lobe(tiles_(Vec2{point.position.x, point.position.y} / tile_side), Diffuse<float>{})};
    }

private:
    void add(Material material) {
        spheres_.push_back({{2.25F * (float(spheres_.size()) - 2.5F), 0, 1}, 1});
        materials_.push_back(std::move(material));
    }

    /// In squares of 22.5 degrees.
    [[nodiscard]] static Vec2 longitude_latitude(const Vec3& n) {
        constexpr float per_radian = 8 / std::numbers::pi_v<float>;
        return {per_radian * std::atan2(n.y, n.x), per_radian * std::asin(n.z)};
    }

    static constexpr float tile_side = 1.6F;

    Plane<float>               floor_{{0, 0, 0}, {0, 0, 1}};
    Checker                    tiles_{{0.62F, 0.60F, 0.56F}, {0.30F, 0.30F, 0.32F}};
    Checker                    globe_{{0.80F, 0.80F, 0.76F}, {0.10F, 0.35F, 0.22F}};
    std::vector<Sphere<float>> spheres_;
    std::vector<Material>      materials_;
};

/// Radiance along a ray: surfaces draw where it comes from until it comes from the sky. Chapter 7 says why this works.
/// @param first  what draws the first of these directions
[[nodiscard]] inline Spectrum radiance(const SphereRow& row, const ClearSky& sky, Ray<float> ray, Vec2 first,
                                       Rng& rng) {
    constexpr int  longest = 24;  // what bounces more often counts next to nothing
    const Spectrum blue{0.86F, 0.97F, 1.20F};
    Spectrum       throughput{1, 1, 1};
    for (int bounce = 0; bounce < longest; ++bounce) {
        const auto hit = row.nearest(ray);
        if (!hit) return float(sky(Vector3<double>(ray.direction))) * (throughput * blue);
        const auto  frame = frame_around(hit->point.normal);
        const float u = rng.uniform(), v = rng.uniform();
        const auto  next = hit->material.sample(frame.to_local(-ray.direction),
                                               bounce == 0 ? first : Vec2{u, v}, TransportMode::radiance);
        if (!next) return {};
        throughput = throughput * next->weight;
        ray        = leave(hit->point, normalize(frame.to_world(next->wi)));
    }
    return {};
}

/// The n-th of a sequence of points that keep away from each other, moved by the same amount: less noise than chance.
/// @see Roberts, The Unreasonable Effectiveness of Quasirandom Sequences (2018)
[[nodiscard]] inline Vec2 spread_point(int n, Vec2 moved) {
    const Vec2 p = moved + float(n) * Vec2{0.75487767F, 0.56984029F};
    return p - glm::floor(p);
}

inline void render_spheres(course::Chapter& chapter) {
    const auto&           options = chapter.options();
    const int             width = options.size, height = std::max(16, width * 3 / 10);
    const Vector3<double> direction{0, 1, -0.09};
    const auto            camera = convert<float>(
        pinhole_camera<double>({0, -14, 2.45}, direction, {0, 0, 1}, 1.0, 0.98, width, height));
    const ClearSky   sky{normalize(Vector3<double>{-0.65, -0.75, 0.9})};
    const SphereRow  row;
    Image<Spectrum>  film(width, height);
    course::Progress progress{"the row of spheres", height};
    const int        side = int(std::lround(std::sqrt(options.samples)));
    for_each_pixel(width, height, {.threads = options.threads}, [&](int x, int y) {
        Spectrum    sum;
        Rng         of_pixel{options.seed, x, y, -1};
        const float first_u = of_pixel.uniform(), first_v = of_pixel.uniform();
        for (int sample = 0; sample < side * side; ++sample) {
            Rng         rng{options.seed, x, y, sample};
            const float u = rng.uniform(), v = rng.uniform();
            const Vec2 at{(float(sample % side) + u) / float(side), (float(sample / side) + v) / float(side)};
            Ray<float> ray   = camera.ray(Vec2(float(x), float(y)) + at);
            ray.direction    = normalize(ray.direction);
            const Spectrum L = radiance(row, sky, ray, spread_point(sample, {first_u, first_v}), rng);
            if (!is_finite(L))
                throw std::runtime_error(fmt::format("pixel {}, {}, sample {}: not finite", x, y, sample));
            sum = sum + L;
        }
        film(x, y) = 0.42F / float(side * side) * sum;
        if (x == 0) progress.tick();
    });
    chapter.render("spheres", "A sphere of each material",
                   "Diffuse, checkered, Phong's lobe, diffuse below Phong's lobe, mirror, glass; under the "
                   "CIE's clear sky.",
                   film);
}

}  // namespace sr
