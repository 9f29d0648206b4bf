#pragma once
/// @file recursion.hpp
/// The recursive ray tracer: light that a point light sends to a surface, and what mirrors and glass show of it.
///
///     const RecursiveTracer tracer(scene, {.depth = 8});
///     RayCount count;
///     const Spectrum L = tracer.radiance(ray, rng, count);
///
/// Only single directions are followed: Phong's lobes, however narrow, show the lights and nothing else. Glass casts
/// shadows as if it were opaque. What shines casts none: a lamp's light stands in it. Nothing lights a surface but the
/// lights themselves: neither what a mirror or a lens throws on it, a caustic, nor the surfaces around it.
/// @see Whitted, An Improved Illumination Model for Shaded Display, CACM 23(6), 1980

#include <cstdint>

#include "sampling/rng.hpp"
#include "scene/scene.hpp"
#include "scene/surfaces.hpp"
#include "transport/interaction.hpp"

namespace sr {

/// What happens where light takes two ways.
enum class Branching {
    split,   ///< both are followed, each with its weight
    random,  ///< one is, drawn as often as its share of the light
};

/// Which of the rays are followed.
struct RecursionOptions {
    int       depth     = 8;  ///< most rays one behind the other, the camera's included, 1 to 1000
    Branching branching = Branching::split;
    float     cut_off   = 0;  ///< a branch that counts no more than this in the pixel ends, 0 to 1 [1]
};

/// How much work pixels were.
struct RayCount {
    std::uint64_t rays        = 0;  ///< that asked for the nearest hit
    std::uint64_t shadow_rays = 0;  ///< that asked whether anything is before a light

    RayCount& operator+=(const RayCount& other) {
        rays += other.rays;
        shadow_rays += other.shadow_rays;
        return *this;
    }
};

class RecursiveTracer {
public:
    /// @throws std::invalid_argument for options out of range, or as check_scene
    explicit RecursiveTracer(const Scene& scene, RecursionOptions options = {});

    /// The radiance that arrives along the ray, equation (7.5).
    /// @param rng  asked where a branch is random, and only there
    /// @throws std::runtime_error if its tree has more than a million rays: where each level has twice as many, a
    ///         depth of 64 would take for ever
    [[nodiscard]] Spectrum radiance(const Ray<float>& ray, Rng& rng, RayCount& count) const;

private:
    using At = Interaction<float>;

    /// One pixel's tree of rays: what is shared by all of its branches.
    struct Tree {
        Rng&          rng;
        RayCount&     count;
        std::uint64_t most_rays;  ///< that may have been counted when it is done
    };
    /// A branch of the tree: its length up to here, and what its light counts in the pixel.
    struct Branch {
        int      depth      = 1;
        Spectrum throughput = {1, 1, 1};
    };

    [[nodiscard]] Spectrum arriving(const Ray<float>& ray, const Branch& branch, Tree tree) const;
    [[nodiscard]] Spectrum from_lights(const At& at, const LobeSum<float>& scattering, Tree tree) const;
    [[nodiscard]] Spectrum from_deltas(const At& at, const LobeSum<float>& scattering, const Branch& branch,
                                       Tree tree) const;

    Surfaces<float>         surfaces_;
    Surfaces<float>         casters_;  ///< of shadows
    std::vector<Material>   materials_;
    std::vector<PointLight> lights_;
    Spectrum                background_;
    RecursionOptions        options_;
};

}  // namespace sr
