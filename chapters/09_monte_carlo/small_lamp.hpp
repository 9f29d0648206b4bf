#pragma once
/// @file small_lamp.hpp
/// Section 9.10: a lamp so small that directions hardly ever find it.

#include <cmath>
#include <cstdint>
#include <numbers>
#include <optional>
#include <vector>

#include "geometry/sphere.hpp"
#include "image/image.hpp"
#include "math/frame.hpp"
#include "moments.hpp"
#include "radiometry/spectrum.hpp"
#include "repeated.hpp"
#include "sampling/cone.hpp"
#include "sampling/hemisphere.hpp"
#include "scene/camera.hpp"

namespace sr {

/// How directions to the lamp are drawn, and whether what they count is clamped.
enum class LampSampling { cosine, clamped, cone };

/// A ball on a floor, both diffuse and white, and a lamp of radius 0.05 above them, of radiance 1.
class SmallLampRoom {
public:
    /// One estimate of the irradiance at a point with this normal.
    [[nodiscard]] double sample(const Vector3<double>& at, const Vector3<double>& normal, LampSampling way,
                                Vector2<double> u) const {
        const auto   to_lamp = lamp.centre - at;
        const double sine    = lamp.radius / length(to_lamp);
        if (way == LampSampling::cone) {
            const auto   w      = frame_around(normalize(to_lamp)).to_world(sample_cone(u, sine));
            const double cosine = dot(w, normal);
            return cosine > 0 && !hidden(at, w) ? cosine * 2 * std::numbers::pi * cone_height(sine) : 0;
        }
        const auto w = frame_around(normal).to_world(sample_cosine_hemisphere(u));
        if (!intersect(lamp, Ray<double>{at, w}) || hidden(at, w)) return 0;
        return way == LampSampling::clamped ? 10 * overhead : std::numbers::pi;
    }

    /// What a camera sees: the floor or the ball, by so many samples in each pixel.
    [[nodiscard]] Image<Spectrum> picture(int size, int samples, LampSampling way, int threads) const {
        const auto camera =
            pinhole_camera<double>({0, -5.5, 2.6}, {0, 5.5, -2.55}, {0, 0, 1}, 1, 0.6, size, size);
        Image<Spectrum> film(size, size);
        for_each_pixel(size, size, {.threads = threads}, [&](int x, int y) {
            Rng    rng{950 + std::uint64_t(way), x, y, 0};
            double sum = 0;
            for (int k = 0; k < samples; ++k) {
                const auto jitter = draw_pair(rng), u = draw_pair(rng);
                sum += seen(camera.ray(Vector2<double>{x, y} + jitter), way, u);
            }
            const auto grey = float(0.6 * sum / (samples * overhead));
            film(x, y)      = {grey, grey, grey};
        });
        return film;
    }

    /// Irradiance right below the lamp.
    static constexpr double overhead = std::numbers::pi * 6.25e-4;

private:
    static constexpr Sphere<double> ball{{0.35, 0.3, 0.6}, 0.6};
    static constexpr Sphere<double> lamp{{-0.6, -0.5, 2}, 0.05};

    [[nodiscard]] double seen(const Ray<double>& ray, LampSampling way, Vector2<double> u) const {
        const double to_ball  = intersect(ball, ray).value_or(HUGE_VAL);
        const double to_floor = ray.direction.z < 0 ? -ray.origin.z / ray.direction.z : HUGE_VAL;
        if (to_ball < to_floor) {
            const auto at = ray.origin + to_ball * ray.direction;
            return sample(at, (at - ball.centre) / ball.radius, way, u);
        }
        return to_floor < HUGE_VAL ? sample(ray.origin + to_floor * ray.direction, {0, 0, 1}, way, u) : 0;
    }

    /// Whether the ball is between a point and the lamp. What starts on it or outside, and away from its middle, never
    /// meets it.
    [[nodiscard]] bool hidden(const Vector3<double>& at, const Vector3<double>& w) const {
        return dot(at - ball.centre, w) < 0 && intersect(ball, Ray<double>{at, w});
    }
};

/// What n directions drawn by the cosine say of a lamp that fills the share q of the projected hemisphere, exactly:
/// each hits it with probability q and then counts 1 / q times the truth.
struct RareHits {
    double q;

    [[nodiscard]] double deviation(int n) const { return std::sqrt((1 - q) / (q * n)); }
    [[nodiscard]] double black(int n) const { return std::exp(n * std::log1p(-q)); }

    /// Of the estimates over the truth: the median number of hits over its mean.
    [[nodiscard]] double median(int n) const {
        double chance = black(n), up_to = chance;
        int    hits = 0;
        while (up_to < 0.5) {
            chance *= (n - hits) / (hits + 1.0) * q / (1 - q);
            up_to += chance;
            ++hits;
        }
        return hits / (n * q);
    }
};

/// Estimates of such a lamp by n directions each, over the truth.
[[nodiscard]] inline std::vector<double> look_for_lamp(double sine, int n, int pixels, int threads) {
    return repeated(pixels, threads, [=](std::uint64_t pixel) {
        Rng rng{960, std::int64_t(pixel), n, 0};
        int hits = 0;
        for (int i = 0; i < n; ++i)
            hits += pdf_cone(sample_cosine_hemisphere(draw_pair(rng)), sine).value > 0 ? 1 : 0;
        return hits / (n * sine * sine);
    });
}

}  // namespace sr
