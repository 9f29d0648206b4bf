#pragma once
/// @file path_tracer.hpp
/// The rendering equation by random paths: at each surface one direction is drawn, and one point that shines.
///
///     const PathTracer tracer(scene);
///     SobolPoint point({.x = x, .y = y, .index = sample});
///     const Spectrum L = tracer.radiance(camera.ray(image), point, count);
///
/// @see Kajiya, The Rendering Equation (SIGGRAPH 1986); Veach, Robust Monte Carlo Methods for Light Transport
///      Simulation (1997), chapters 8 to 10

#include <concepts>
#include <cstdint>
#include <functional>
#include <string_view>
#include <vector>

#include "sampling/sample_point.hpp"
#include "scene/scene.hpp"
#include "scene/surfaces.hpp"
#include "transport/emitters.hpp"
#include "transport/interaction.hpp"

namespace sr {

/// How a path finds what shines.
enum class Strategy {
    blind,  ///< by chance; directions above a surface are drawn uniformly
    bsdf,   ///< by chance; directions are drawn by the BSDF
    light,  ///< by a point of a light at each surface; what is met by chance counts where that can't be, after a mirror
    balance,  ///< by both, and each way counts by the balance heuristic
    power,    ///< by both, and each way counts by the power heuristic, of exponent 2
};

/// Which paths there are, and how they are found.
struct PathOptions {
    Strategy strategy = Strategy::power;
    int      bounces  = 1000;  ///< at most so many, 0 to 100 000: what longer paths bring is missing
    int roulette = 3;  ///< from so many bounces on, paths end by chance; never if it is as large as `bounces`
    TriangleSampling triangles = TriangleSampling::by_distance;
};

/// How much work paths were.
struct PathCount {
    std::uint64_t paths = 0, rays = 0, shadow_rays = 0;

    PathCount& operator+=(const PathCount& other);
};

/// Told of light that a path finds: the way it took, and what it brings.
/// @param way  Heckbert's notation, from the light L to the eye E: S for a bounce of a mirror or of glass, D for any
///             other, "LSDE" for what shines through a lens on paper
/// @see Heckbert, Adaptive Radiosity Textures for Bidirectional Ray Tracing (SIGGRAPH 1990)
using FoundLight = std::function<void(std::string_view way, Spectrum L)>;

class PathTracer {
public:
    /// @throws std::invalid_argument for options out of range, or as check_scene
    explicit PathTracer(const Scene& scene, PathOptions options = {});

    /// The radiance that arrives along the ray, by one path.
    /// @tparam P  RandomPoint, StratifiedPoint, HaltonPoint or SobolPoint
    template <SamplePoint P>
    [[nodiscard]] Spectrum radiance(const Ray<float>& ray, P& point, PathCount& count) const;

    /// The same path; `found` is told each of the terms whose sum is the radiance, none of which is 0.
    template <SamplePoint P>
    void each_light(const Ray<float>& ray, P& point, PathCount& count, const FoundLight& found) const;

private:
    using At = Interaction<float>;

    /// Where a path has got to.
    struct Path {
        Ray<float>               ray;
        Spectrum                 throughput = {1, 1, 1};  ///< what light that is found here counts
        float                    squeezed   = 1;   ///< the part of it that is no loss: n^2 of refraction
        SurfacePoint<float>      from       = {};  ///< where the ray comes from,
        Pdf<measure::SolidAngle> pdf        = {};  ///< with this density
        bool                     is_delta   = false;
        bool only_way = true;  ///< and lights can't be drawn from there: the camera, a mirror
    };

    template <SamplePoint P, class Watch>
    void walk(const Ray<float>& ray, P& point, PathCount& count, Watch& watch) const;

    [[nodiscard]] Spectrum emitted(const Path& path, const Material& material,
                                   const SurfaceHit<float>& hit) const;
    [[nodiscard]] Spectrum of_background(const Path& path) const;
    [[nodiscard]] Spectrum from_light(const At& at, const LobeSum<float>& scattering, Vec2 u,
                                      PathCount& count) const;
    [[nodiscard]] bool     scatter(Path& path, const At& at, const LobeSum<float>& scattering, Vec2 u) const;
    [[nodiscard]] bool     survives(Path& path, float u) const;

    /// What a way counts that was drawn with the first density, and could have been with the second.
    [[nodiscard]] float weight(Pdf<measure::SolidAngle> drawn, Pdf<measure::SolidAngle> other) const;

    Surfaces<float>       surfaces_;
    Emitters              emitters_;
    std::vector<Material> materials_;
    Spectrum              background_;
    PathOptions           options_;
    float                 most_likely_;  ///< that a path goes on
};

}  // namespace sr
