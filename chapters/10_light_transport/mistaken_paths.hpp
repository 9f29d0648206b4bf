#pragma once
/// @file mistaken_paths.hpp
/// A path tracer as one writes it in an afternoon, with one of the mistakes that one makes.

#include <numbers>
#include <optional>

#include "sampling/hemisphere.hpp"
#include "sampling/random_point.hpp"
#include "scene/surfaces.hpp"
#include "transport/emitters.hpp"
#include "transport/interaction.hpp"

namespace sr {

enum class Mistake {
    none,
    no_pi,            ///< rho instead of rho / pi where a light is asked
    no_cosine,        ///< none there either
    density,          ///< the light's density is 20 % too large
    twice,            ///< what shines counts also where a path meets it by chance
    no_shadow,        ///< nothing is ever between
    two_bounces,      ///< paths end after two
    wrong_directions  ///< uniform ones, as if they followed the cosine
};

/// Diffuse surfaces, lit by a point of a light at each, and roulette by their reflectance.
class MistakenPaths {
public:
    MistakenPaths(const Scene& scene, Mistake mistake) : scene_{scene}, mistake_{mistake} {}

    [[nodiscard]] Spectrum radiance(Ray<float> ray, RandomPoint& point) const {
        Spectrum L, throughput{1, 1, 1};
        for (int bounces = 0;; ++bounces) {
            const auto hit    = surfaces_.nearest(ray);
            const bool counts = bounces == 0 || mistake_ == Mistake::twice;
            if (counts)
                L = L + throughput * (hit ? scene_.materials[hit->material].emission : scene_.background);
            if (!hit || (mistake_ == Mistake::two_bounces && bounces == 2)) return L;
            const Interaction<float> at(hit->point, ray.direction, Sides::alike);
            const Spectrum           rho      = scene_.materials[hit->material].reflectance();
            const auto               on_light = point.pair<float>(), up = point.pair<float>();
            L = L + throughput * rho * lit(at, on_light);
            // a path goes on with the chance rho of green, and its light is divided by that
            if (!(point.number<float>() < rho.g)) return L;
            throughput = throughput * rho / rho.g;
            ray        = at.leave(mistake_ == Mistake::wrong_directions ? sample_uniform_hemisphere(up)
                                                                        : sample_cosine_hemisphere(up));
        }
    }

private:
    /// What one light sends to white paper there, over pi.
    [[nodiscard]] Spectrum lit(const Interaction<float>& at, Vec2 u) const {
        const auto light = emitters_.sample(at.point(), u);
        if (!light) return {};
        const float cosine = at.to_local(light->direction).z;
        if (!(cosine > 0)) return {};
        if (mistake_ != Mistake::no_shadow && surfaces_.occluded(light->ray, light->range)) return {};
        float factor = cosine / std::numbers::pi_v<float>;
        if (mistake_ == Mistake::no_pi) factor *= std::numbers::pi_v<float>;
        if (mistake_ == Mistake::no_cosine) factor /= cosine;
        if (mistake_ == Mistake::density) factor /= 1.2F;
        return factor * light->arriving;
    }

    Scene           scene_;
    Mistake         mistake_;
    Surfaces<float> surfaces_{scene_};
    Emitters        emitters_{scene_};
};

}  // namespace sr
