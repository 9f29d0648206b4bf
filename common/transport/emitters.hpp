#pragma once
/// @file emitters.hpp
/// All that shines in a scene, as something that directions are drawn from: towards the light, instead of hoping to
/// meet it.
///
///     const Emitters emitters(scene);
///     if (const auto light = emitters.sample(point, u))
///         if (!surfaces.occluded(light->ray, light->range)) L = L + f * cosine * light->arriving;

#include <cstdint>
#include <optional>
#include <variant>
#include <vector>

#include "geometry/offset.hpp"
#include "geometry/ray.hpp"
#include "math/interval.hpp"
#include "sampling/pdf.hpp"
#include "sampling/piecewise_constant.hpp"
#include "scene/scene.hpp"
#include "scene/surfaces.hpp"

namespace sr {

/// How directions to a triangle that shines are drawn.
enum class TriangleSampling {
    area,         ///< by its points, each as likely: near it, some count without bound
    solid_angle,  ///< by its image on the unit sphere: never worse, but four times the work
    by_distance,  ///< by solid angle nearby, by area from where the triangle is small
};

/// A direction to a light, and what comes from there if nothing is between: if `ray` meets nothing in `range`.
struct LightSample {
    Ray<float>      ray;
    Interval<float> range;
    Vec3            direction;  ///< unit vector to the light
    Spectrum        arriving;   ///< radiance over pdf; a point light's intensity over r^2 [W/m^2]
    Pdf<measure::SolidAngle>
        pdf;  ///< of the direction and the light's choice; 0 of a point, which no ray meets
};

/// Point lights, faces and balls that shine, and the background if it does. One of them is drawn, as often as its
/// share of the power of all, then a direction to it: to a ball uniformly in its cone, to the background by the
/// cosine.
class Emitters {
public:
    /// @pre as check_scene
    explicit Emitters(const Scene& scene, TriangleSampling triangles = TriangleSampling::by_distance);

    /// None if nothing shines, or what was drawn can't be seen from there: it lies in the lamp's plane, for one.
    /// @param from  whose normal points to where light is to come from
    /// @param u     uniform in [0, 1)^2
    [[nodiscard]] std::optional<LightSample> sample(const SurfacePoint<float>& from, Vec2 u) const;

    /// The density with which `sample` draws the direction of a ray that leaves `from` and meets a surface, which
    /// shines.
    [[nodiscard]] Pdf<measure::SolidAngle> pdf(const SurfacePoint<float>& from, const Vec3& direction,
                                               const SurfaceHit<float>& hit) const;

    /// The same if it meets nothing.
    [[nodiscard]] Pdf<measure::SolidAngle> pdf_of_background(const SurfacePoint<float>& from,
                                                             const Vec3&                direction) const;

private:
    struct Face {
        Triangle<float> triangle;
        Spectrum        radiance;
        Vec3            normal;  ///< unit vector
        bool            shines_behind;
        float           area;
        Vec3            middle;
        float           far;  ///< squared distance of the middle from which the triangle counts as small
    };
    struct Globe {
        Sphere<float> sphere;
        Spectrum      radiance;
    };
    struct Sky {
        Spectrum radiance;
    };
    using Emitter = std::variant<PointLight, Face, Globe, Sky>;

    void add(const Emitter& emitter, double power);

    [[nodiscard]] std::optional<LightSample> drawn(const PointLight& light, const SurfacePoint<float>& from,
                                                   Vec2 u) const;
    [[nodiscard]] std::optional<LightSample> drawn(const Face& face, const SurfacePoint<float>& from,
                                                   Vec2 u) const;
    [[nodiscard]] std::optional<LightSample> drawn(const Globe& globe, const SurfacePoint<float>& from,
                                                   Vec2 u) const;
    [[nodiscard]] std::optional<LightSample> drawn(const Sky& sky, const SurfacePoint<float>& from,
                                                   Vec2 u) const;

    [[nodiscard]] bool                     by_area(const Face& face, const Vec3& from) const;
    [[nodiscard]] Pdf<measure::SolidAngle> density(const Face& face, const Vec3& from, const Vec3& direction,
                                                   const Vec3& hit) const;

    TriangleSampling                         triangles_;
    std::vector<Emitter>                     emitters_;
    std::vector<double>                      powers_;
    std::optional<PiecewiseConstant<double>> choice_;
    std::vector<std::int32_t>                of_surface_;  ///< which emitter a surface is, or -1
    std::int32_t                             sky_ = -1;
};

}  // namespace sr
