/// @file recursion.cpp

#include "transport/recursion.hpp"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

#include "radiometry/solid_angle.hpp"
#include "scene/lamps.hpp"
#include "transport/single_directions.hpp"

namespace sr {

namespace {

constexpr std::uint64_t most_rays = 1'000'000;  ///< of one tree

Sides sides_of(const Material& material) {
    return material.is_transparent() ? Sides::two : Sides::alike;
}

bool exceeds(Spectrum s, float bound) {
    return s.r > bound || s.g > bound || s.b > bound;
}

}  // namespace

RecursiveTracer::RecursiveTracer(const Scene& scene, RecursionOptions options)
    : surfaces_{scene},
      casters_{without_lamps(scene)},
      materials_{scene.materials},
      lights_{scene.lights},
      background_{scene.background},
      options_{options} {
    if (!(options.depth >= 1 && options.depth <= 1000))
        throw std::invalid_argument(fmt::format("recursion depth {}: must be 1 to 1000", options.depth));
    if (!(options.cut_off >= 0 && options.cut_off <= 1))
        throw std::invalid_argument(fmt::format("recursion cut-off {}: must be 0 to 1", options.cut_off));
}

Spectrum RecursiveTracer::radiance(const Ray<float>& ray, Rng& rng, RayCount& count) const {
    return arriving(ray, {}, {rng, count, count.rays + most_rays});
}

Spectrum RecursiveTracer::arriving(const Ray<float>& ray, const Branch& branch, Tree tree) const {
    if (++tree.count.rays > tree.most_rays)
        throw std::runtime_error(fmt::format(
            "a pixel's tree of rays, of depth {} and cut-off {}, has more than {}; take a smaller "
            "depth or a larger cut-off",
            options_.depth, options_.cut_off, most_rays));
    const auto hit = surfaces_.nearest(ray);
    if (!hit) return background_;
    const Material& material = materials_[hit->material];
    const At        at(hit->point, ray.direction, sides_of(material));
    // (7.5) what it emits, what it scatters of the lights, and what is seen in it
    const Spectrum  shown = material.emission + from_lights(at, material.scattering, tree);
    if (branch.depth == options_.depth) return shown;
    return shown + from_deltas(at, material.scattering, branch, tree);
}

Spectrum RecursiveTracer::from_lights(const At& at, const LobeSum<float>& scattering, Tree tree) const {
    Spectrum L;
    for (const auto& light : lights_) {
        const Vec3     to_light = Vec3(light.position()) - at.point().position;
        const Vec3     wi       = at.to_local(normalize(to_light));
        const Spectrum f        = scattering.f(at.wo(), wi);
        if (f == Spectrum{}) continue;
        ++tree.count.shadow_rays;
        if (casters_.occluded(between(at.point(), Vec3(light.position())), before_the_end<float>)) continue;
        // (7.2) the irradiance I cos / r^2
        const auto E = Intensity<Spectrum>{light.intensity()} *
                       solid_angle_per_area(std::abs(wi.z), Length<float>{length(to_light)});
        L = L + f * E.value();
    }
    return L;
}

Spectrum RecursiveTracer::from_deltas(const At& at, const LobeSum<float>& scattering, const Branch& branch,
                                      Tree tree) const {
    Spectrum   L;
    const auto follow = [&](const Vec3& wi, Spectrum weight) {
        // a branch ends where it counts too little, however short it is
        const Branch longer{branch.depth + 1, branch.throughput * weight};
        if (exceeds(longer.throughput, options_.cut_off))
            L = L + weight * arriving(at.leave(wi), longer, tree);
    };
    if (options_.branching == Branching::split) {
        for_each_single_direction(scattering, at.wo(), follow);
    } else {
        const float x = tree.rng.uniform(), y = tree.rng.uniform();
        draw_single_direction(scattering, at.wo(), {x, y}, follow);
    }
    return L;
}

}  // namespace sr
