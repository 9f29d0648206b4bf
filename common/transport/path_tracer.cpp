/// @file path_tracer.cpp

#include "transport/path_tracer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <string>
#include <variant>

#include "math/square.hpp"
#include "sampling/halton_point.hpp"
#include "sampling/hemisphere.hpp"
#include "sampling/random_point.hpp"
#include "sampling/sobol_point.hpp"
#include "sampling/stratified_point.hpp"

namespace sr {
namespace {

Sides sides_of(const Material& material) {
    return material.is_transparent() ? Sides::two : Sides::alike;
}

/// Roulette lets a path go on with the chance q. Where light keeps the share rho at each bounce, the variance is finite
/// only if q > rho^2: q may be as small as the largest rho, and need not be above 0.95 where that is less.
/// @see Arvo and Kirk, Particle Transport and Image Synthesis (SIGGRAPH 1990)
float most_likely_to_go_on(const Scene& scene) {
    float rho = 0.95F;
    for (const auto& material : scene.materials) rho = std::max(rho, largest(material.reflectance()));
    return std::min(rho, 1.0F);
}

/// A direction above the surface, each as likely, whatever the BSDF.
std::optional<BsdfSample<float, Spectrum>> blind_sample(const LobeSum<float>& scattering, const Vec3& wo,
                                                        Vec2 u) {
    const Vec3 wi = sample_uniform_hemisphere(u);
    const auto p  = pdf_uniform_hemisphere(wi);
    return BsdfSample<float, Spectrum>{wi, float(double(wi.z) / p.value) * scattering.f(wo, wi), p};
}

bool only_spreads(const LobeSum<float>& scattering) {
    return std::ranges::none_of(scattering.lobes(), [](const auto& part) {
        return std::holds_alternative<Mirror<float>>(part.lobe) ||
               std::holds_alternative<Dielectric<float>>(part.lobe);
    });
}

}  // namespace

PathCount& PathCount::operator+=(const PathCount& other) {
    paths += other.paths;
    rays += other.rays;
    shadow_rays += other.shadow_rays;
    return *this;
}

PathTracer::PathTracer(const Scene& scene, PathOptions options)
    : surfaces_{scene},
      emitters_{scene, options.triangles},
      materials_{scene.materials},
      background_{scene.background},
      options_{options},
      most_likely_{most_likely_to_go_on(scene)} {
    if (!(options.bounces >= 0 && options.bounces <= 100'000))
        throw std::invalid_argument(fmt::format("{} bounces: must be 0 to 100000", options.bounces));
    if (!(options.roulette >= 0))
        throw std::invalid_argument(
            fmt::format("roulette from bounce {}: must be 0 or more", options.roulette));
}

template <SamplePoint P, class Watch>
void PathTracer::walk(const Ray<float>& ray, P& point, PathCount& count, Watch& watch) const {
    ++count.paths;
    Path path{ray};
    for (int bounces = 0;; ++bounces) {
        ++count.rays;
        const auto hit = surfaces_.nearest(path.ray);
        if (!hit) return watch.meets(of_background(path));
        const Material& material = materials_[hit->material];
        // what shines here, times what light from here counts
        watch.meets(emitted(path, material, *hit));
        if (bounces == options_.bounces) return;

        const At   at(hit->point, path.ray.direction, sides_of(material));
        const auto on_light = point.template pair<float>();
        const auto on_bsdf  = point.template pair<float>();
        // light that is asked for; light that bounces follows
        watch.is_lit(path.throughput * from_light(at, material.scattering, on_light, count));
        if (!scatter(path, at, material.scattering, on_bsdf)) return;
        watch.bounces(path.is_delta);
        if (bounces >= options_.roulette && !survives(path, point.template number<float>())) return;
    }
}

template <SamplePoint P>
Spectrum PathTracer::radiance(const Ray<float>& ray, P& point, PathCount& count) const {
    struct {
        Spectrum L;
        void     meets(Spectrum emitted) { L = L + emitted; }
        void     is_lit(Spectrum reflected) { L = L + reflected; }
        void     bounces(bool) {}
    } sum;
    walk(ray, point, count, sum);
    return sum.L;
}

template <SamplePoint P>
void PathTracer::each_light(const Ray<float>& ray, P& point, PathCount& count,
                            const FoundLight& found) const {
    struct {
        const FoundLight& found;
        std::string       way = "E";  // of the bounces up to here, the last first
        void              meets(Spectrum emitted) { tell("L" + way, emitted); }
        void              is_lit(Spectrum reflected) { tell("LD" + way, reflected); }
        void              bounces(bool is_delta) { way.insert(0, is_delta ? "S" : "D"); }
        void              tell(const std::string& whole_way, Spectrum L) const {
                         if (L != Spectrum{}) found(whole_way, L);
        }
    } watch{found};
    walk(ray, point, count, watch);
}

float PathTracer::weight(Pdf<measure::SolidAngle> drawn, Pdf<measure::SolidAngle> other) const {
    // p / (p + q) and p^2 / (p^2 + q^2), by q / p: neither overflows
    const double ratio = other.value / drawn.value;
    return float(1 / (1 + (options_.strategy == Strategy::power ? square(ratio) : ratio)));
}

Spectrum PathTracer::emitted(const Path& path, const Material& material, const SurfaceHit<float>& hit) const {
    if (material.emission == Spectrum{}) return {};
    if (!material.shines_behind && dot(hit.point.normal, path.ray.direction) > 0) return {};
    const Spectrum L = path.throughput * material.emission;
    if (path.only_way) return L;
    // the surface that the path comes from has asked for this light
    if (options_.strategy == Strategy::light) return {};
    return weight(path.pdf, emitters_.pdf(path.from, path.ray.direction, hit)) * L;
}

Spectrum PathTracer::of_background(const Path& path) const {
    const Spectrum L = path.throughput * background_;
    if (path.only_way) return L;
    if (options_.strategy == Strategy::light) return {};
    return weight(path.pdf, emitters_.pdf_of_background(path.from, path.ray.direction)) * L;
}

Spectrum PathTracer::from_light(const At& at, const LobeSum<float>& scattering, Vec2 u,
                                PathCount& count) const {
    if (options_.strategy == Strategy::blind || options_.strategy == Strategy::bsdf) return {};
    const auto light = emitters_.sample(at.point(), u);
    if (!light) return {};
    const Vec3     wi = at.to_local(light->direction);
    const Spectrum f  = scattering.f(at.wo(), wi);
    if (f == Spectrum{}) return {};
    ++count.shadow_rays;
    if (surfaces_.occluded(light->ray, light->range)) return {};
    const bool  only_way = options_.strategy == Strategy::light || light->pdf.value == 0;
    const float w        = only_way ? 1 : weight(light->pdf, scattering.pdf(at.wo(), wi));
    return w * std::abs(wi.z) * f * light->arriving;
}

bool PathTracer::scatter(Path& path, const At& at, const LobeSum<float>& scattering, Vec2 u) const {
    const bool blind = options_.strategy == Strategy::blind && only_spreads(scattering);
    const auto sample =
        blind ? blind_sample(scattering, at.wo(), u) : scattering.sample(at.wo(), u, TransportMode::radiance);
    if (!sample || sample->weight == Spectrum{}) return false;
    // f cos / p, which is what light from the next surface counts here
    path.throughput = path.throughput * sample->weight;
    path.squeezed *= sample->squeezed;
    path.ray      = at.leave(sample->wi);
    path.from     = at.point();
    path.pdf      = sample->pdf;
    path.is_delta = sample->is_delta;
    path.only_way =
        sample->is_delta || options_.strategy == Strategy::blind || options_.strategy == Strategy::bsdf;
    return true;
}

bool PathTracer::survives(Path& path, float u) const {
    // what is left of the light; who goes on also counts for those who did not
    const float q = std::min(most_likely_, largest(path.throughput) / path.squeezed);
    if (!(u < q)) return false;
    path.throughput = path.throughput / q;
    return true;
}

template Spectrum PathTracer::radiance(const Ray<float>&, RandomPoint&, PathCount&) const;
template Spectrum PathTracer::radiance(const Ray<float>&, StratifiedPoint&, PathCount&) const;
template Spectrum PathTracer::radiance(const Ray<float>&, HaltonPoint&, PathCount&) const;
template Spectrum PathTracer::radiance(const Ray<float>&, SobolPoint&, PathCount&) const;

template void PathTracer::each_light(const Ray<float>&, RandomPoint&, PathCount&, const FoundLight&) const;
template void PathTracer::each_light(const Ray<float>&, StratifiedPoint&, PathCount&,
                                     const FoundLight&) const;
template void PathTracer::each_light(const Ray<float>&, HaltonPoint&, PathCount&, const FoundLight&) const;
template void PathTracer::each_light(const Ray<float>&, SobolPoint&, PathCount&, const FoundLight&) const;

}  // namespace sr
