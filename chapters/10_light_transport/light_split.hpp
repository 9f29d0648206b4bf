#pragma once
/// @file light_split.hpp
/// Section 10.3: light that reaches a surface directly, by both ways of finding it, each with its weight.

#include <cmath>
#include <vector>

#include "math/square.hpp"
#include "scene/surfaces.hpp"
#include "transport/emitters.hpp"
#include "transport/interaction.hpp"

namespace sr {

/// What each way brings, by the power heuristic.
struct LightParts {
    Spectrum asked, met;
};

/// The lamps' light at the first surface of opaque materials, split by how it was found.
class LightSplit {
public:
    /// @param mistake  factor of the lamps' density where light is met, for weights that don't add up to 1
    explicit LightSplit(const Scene& scene, double mistake = 1)
        : surfaces_{scene}, emitters_{scene}, materials_{scene.materials}, mistake_{mistake} {}

    /// By one path: black where a lamp is seen, or nothing.
    template <class P>
    [[nodiscard]] LightParts parts(const Ray<float>& ray, P& point) const {
        const auto hit = surfaces_.nearest(ray);
        if (!hit || materials_[hit->material].emission != Spectrum{}) return {};
        const Interaction<float> at(hit->point, ray.direction, Sides::alike);
        const auto&              scattering = materials_[hit->material].scattering;
        const auto on_light = point.template pair<float>(), on_bsdf = point.template pair<float>();
        return {asked(at, scattering, on_light), met(at, scattering, on_bsdf)};
    }

private:
    [[nodiscard]] static float weight(double drawn, double other) {
        return float(square(drawn) / (square(drawn) + square(other)));
    }

    [[nodiscard]] Spectrum asked(const Interaction<float>& at, const LobeSum<float>& scattering,
                                 Vec2 u) const {
        const auto light = emitters_.sample(at.point(), u);
        if (!light || surfaces_.occluded(light->ray, light->range)) return {};
        const Vec3 wi = at.to_local(light->direction);
        return weight(light->pdf.value, scattering.pdf(at.wo(), wi).value) * std::abs(wi.z) *
               scattering.f(at.wo(), wi) * light->arriving;
    }

    [[nodiscard]] Spectrum met(const Interaction<float>& at, const LobeSum<float>& scattering, Vec2 u) const {
        const auto bounce = scattering.sample(at.wo(), u, TransportMode::radiance);
        if (!bounce) return {};
        const auto ray = at.leave(bounce->wi);
        const auto hit = surfaces_.nearest(ray);
        if (!hit || materials_[hit->material].emission == Spectrum{}) return {};
        const double p = emitters_.pdf(at.point(), ray.direction, *hit).value;
        return weight(bounce->pdf.value, mistake_ * p) * bounce->weight * materials_[hit->material].emission;
    }

    Surfaces<float>       surfaces_;
    Emitters              emitters_;
    std::vector<Material> materials_;
    double                mistake_;
};

}  // namespace sr
