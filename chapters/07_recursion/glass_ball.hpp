#pragma once
/// @file glass_ball.hpp
/// Section 7.8: a ball of glass before a sky of checks, by rays that leave its surface in one way or another. In exact
/// arithmetic, its picture is the same at all sizes.

#include <cmath>
#include <numbers>

#include "inside_glass.hpp"
#include "picture.hpp"
#include "transport/single_directions.hpp"

namespace sr {

/// Twelve bright and twelve dark checks all around, on a sky that is blue above and red below.
[[nodiscard]] inline Spectrum checked_sky(const Vec3& d) {
    const auto check   = [](float angle) { return int(std::floor(angle * 12 / std::numbers::pi_v<float>)); };
    const bool dark    = (check(std::atan2(d.x, d.z)) + check(std::asin(d.y))) % 2 == 0;
    const Spectrum sky = d.y > 0 ? Spectrum{0.3F, 0.5F, 0.9F} : Spectrum{0.9F, 0.5F, 0.3F};
    return dark ? 0.25F * sky : sky;
}

inline const LobeSum<float> clear_glass{{{{1, 1, 1}, Dielectric<float>{1.5F}}}};

/// The radiance of (7.5) along a ray that is the depth-th of its branch, at most eight deep.
template <class Depart>
[[nodiscard]] Spectrum past_glass_ball(const Sphere<float>& ball, const Departure& from, int depth,
                                       const Depart& depart) {
    const auto t = intersect(ball, from.ray, from.range);
    if (!t) return checked_sky(from.ray.direction);
    Spectrum L;
    if (depth == 8) return L;
    const Interaction<float> at(surface_point(ball, from.ray, *t), from.ray.direction, Sides::two);
    for_each_single_direction(clear_glass, at.wo(), [&](const Vec3& wi, Spectrum weight) {
        const Departure next = depart(at.point(), at.leave(wi).direction);
        L                    = L + weight * past_glass_ball(ball, next, depth + 1, depart);
    });
    return L;
}

/// The ball from four radii away, in so many pixels across.
template <class Depart>
[[nodiscard]] Image<Spectrum> picture_of_glass_ball(double radius, int side, const PixelSampling& sampling,
                                                    const TileLoop& loop, const Depart& depart) {
    const Vector3<double> centre = radius * Vector3<double>{7, 5, 3}, back{0, 0, 4 * radius};
    const Sphere<float>   ball{Vec3(centre), float(radius)};
    const auto camera = pinhole_camera<double>(centre - back, {0, 0, 1}, {0, 1, 0}, 1, 0.6, side, side);
    return render(convert<float>(camera), sampling, loop, [&](const Ray<float>& ray, Rng&) {
        return past_glass_ball(ball, {{ray.origin, normalize(ray.direction)}}, 1, depart);
    });
}

/// The number of pixels that differ by more than 0.01 of white.
[[nodiscard]] inline int differing(const Image<Spectrum>& a, const Image<Spectrum>& b) {
    int count = 0;
    for (std::size_t i = 0; i < a.pixels().size(); ++i) {
        const Spectrum d    = a.pixels()[i] - b.pixels()[i];
        const bool     same = std::abs(d.r) <= 0.01F && std::abs(d.g) <= 0.01F && std::abs(d.b) <= 0.01F;
        count += same ? 0 : 1;
    }
    return count;
}

}  // namespace sr
