#pragma once
/// @file surfaces.hpp
/// All that a ray can meet in a scene, and where it goes on from there.
///
///     const Surfaces<float> surfaces(scene);
///     if (const auto hit = surfaces.nearest(ray)) shade(hit->point, scene.materials[hit->material]);

#include <cmath>
#include <concepts>
#include <cstdint>
#include <optional>
#include <vector>

#include "geometry/hierarchy.hpp"
#include "geometry/offset.hpp"
#include "geometry/triangle_packs.hpp"
#include "scene/scene.hpp"

namespace sr {

template <std::floating_point T>
struct SurfaceHit {
    T               t;
    SurfacePoint<T> point;
    std::uint32_t   material;
    std::uint32_t   surface;  ///< its number: the faces' first, then the balls'
};

/// A scene's triangles in a hierarchy, or in packs if they are few, and its balls in a list, rounded to T.
template <std::floating_point T>
class Surfaces {
public:
    /// @throws std::invalid_argument as check_scene
    explicit Surfaces(const Scene& scene)
        : mesh_{checked_mesh(scene)}, material_of_face_{scene.material_of_face} {
        if (mesh_.faces.size() <= most_in_packs)
            packs_.emplace(mesh_);
        else
            hierarchy_.emplace(mesh_);
        for (std::size_t face = 0; face < mesh_.faces.size(); ++face)
            normals_.push_back(normalize(area_vector(mesh_.triangle(face))));
        for (const auto& [sphere, material] : scene.balls)
            balls_.push_back({{Vector3<T>(sphere.centre), T(sphere.radius)}, material});
    }

    /// The hit with the least t in `range`.
    /// @pre range.min >= 0
    [[nodiscard]] std::optional<SurfaceHit<T>> nearest(const Ray<T>& ray,
                                                       Interval<T>   range = in_front<T>) const {
        const auto face = on_faces(ray, range);
        if (face) range.max = face->t;
        const RoundedBall* ball = nullptr;
        for (const auto& candidate : balls_) {
            if (const auto t = intersect(candidate.sphere, ray, range)) {
                range.max = *t;
                ball      = &candidate;
            }
        }
        if (ball)
            return SurfaceHit<T>{
                range.max, surface_point(ball->sphere, ray, range.max), ball->material,
                std::uint32_t(material_of_face_.size()) + std::uint32_t(ball - balls_.data())};
        if (face)
            return SurfaceHit<T>{face->t, on_face(*face, ray), material_of_face_[face->face], face->face};
        return std::nullopt;
    }

    /// Whether anything is hit in `range`.
    /// @pre range.min >= 0
    [[nodiscard]] bool occluded(const Ray<T>& ray, Interval<T> range = in_front<T>) const {
        for (const auto& ball : balls_) {
            if (intersect(ball.sphere, ray, range)) return true;
        }
        return packs_ ? packs_->occluded(ray, range) : hierarchy_->occluded(ray, range);
    }

private:
    struct RoundedBall {
        Sphere<T>     sphere;
        std::uint32_t material;
    };

    static constexpr std::size_t most_in_packs = 64;

    static Mesh<T> checked_mesh(const Scene& scene) {
        check_scene(scene);
        return convert<T>(scene.mesh);
    }

    [[nodiscard]] std::optional<MeshHit<T>> on_faces(const Ray<T>& ray, Interval<T> range) const {
        if (packs_) return packs_->nearest(ray, range);
        return hierarchy_->nearest(ray, range);
    }

    /// A triangle too small for its normal to be computed faces the ray that found it.
    [[nodiscard]] SurfacePoint<T> on_face(const MeshHit<T>& hit, const Ray<T>& ray) const {
        auto point = surface_point(mesh_.triangle(hit.face), hit.uv, normals_[hit.face]);
        if (!std::isfinite(size_of(point.normal))) point.normal = -normalize(ray.direction);
        return point;
    }

    Mesh<T>                         mesh_;
    std::vector<Vector3<T>>         normals_;  ///< of the faces
    std::optional<TrianglePacks<T>> packs_;
    std::optional<Hierarchy<T>>     hierarchy_;
    std::vector<std::uint32_t>      material_of_face_;
    std::vector<RoundedBall>        balls_;
};

}  // namespace sr
