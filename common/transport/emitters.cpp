/// @file emitters.cpp

#include "transport/emitters.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "math/frame.hpp"
#include "math/square.hpp"
#include "sampling/cone.hpp"
#include "sampling/hemisphere.hpp"
#include "sampling/sphere.hpp"
#include "sampling/spherical_triangle.hpp"
#include "sampling/triangle_points.hpp"
#include "sampling/unit_interval.hpp"

namespace sr {
namespace {

constexpr double pi = std::numbers::pi;

/// Of a sphere around all vertices and balls: what a background's light comes through.
double squared_radius_of(const Scene& scene) {
    Vector3<double> low{1e300, 1e300, 1e300}, high{-low};
    const auto      include = [&](const Vector3<double>& p, double r) {
        low  = glm::min(low, p - Vector3<double>{r, r, r});
        high = glm::max(high, p + Vector3<double>{r, r, r});
    };
    for (const auto& vertex : scene.mesh.vertices) include(vertex, 0);
    for (const auto& ball : scene.balls) include(ball.sphere.centre, ball.sphere.radius);
    return low.x <= high.x ? dot(high - low, high - low) / 4 : 1;
}

/// From three times the distance of the furthest corner, the nearest point is at most twice as near as the furthest:
/// points that are equally likely count up to four times as much as others, no more.
float far_from(const Triangle<float>& triangle, const Vec3& middle) {
    float furthest = 0;
    for (const Vec3& corner : {triangle.a, triangle.b, triangle.c})
        furthest = std::max(furthest, dot(corner - middle, corner - middle));
    return 9 * furthest;
}

/// Sine of the half-angle of the cone in which a ball is seen; none from inside, from where it is everywhere.
std::optional<float> sine_of_cone(const Sphere<float>& sphere, const Vec3& from) {
    const float distance = length(sphere.centre - from);
    if (distance < sphere.radius) return std::nullopt;
    return sphere.radius / distance;
}

/// Whether a point lies in a triangle's plane, as far as rounding can tell. Nothing arrives from there, and the solid
/// angle that it has is 0 or, from within the triangle, anything.
bool is_in_plane(const SurfacePoint<float>& point, const Triangle<float>& triangle, const Vec3& normal) {
    return !(std::abs(dot(point.position - triangle.a, normal)) > point.error);
}

/// Where a ray that was drawn towards a ball meets it; at its edge, where it comes nearest.
float distance_to(const Sphere<float>& sphere, const Ray<float>& ray) {
    const auto t = intersect(sphere, ray);
    return t ? *t : dot(sphere.centre - ray.origin, ray.direction);
}

}  // namespace

Emitters::Emitters(const Scene& scene, TriangleSampling triangles)
    : triangles_{triangles}, of_surface_(scene.mesh.faces.size() + scene.balls.size(), -1) {
    const Mesh<float> mesh = convert<float>(scene.mesh);
    for (const auto& light : scene.lights) add(light, 4 * pi * double(mean(light.intensity())));
    for (std::size_t i = 0; i < scene.mesh.faces.size(); ++i) {
        const Material& material = scene.materials[scene.material_of_face[i]];
        const Spectrum  L        = material.emission;
        const auto&     face     = mesh.triangle(i);
        const double    A        = double(area(face));
        if (L == Spectrum{} || !(A > 0)) continue;
        of_surface_[i]    = std::int32_t(emitters_.size());
        const Vec3 middle = (face.a + face.b + face.c) / 3.0F;
        add(Face{face, L, normalize(area_vector(face)), material.shines_behind, float(A), middle,
                 far_from(face, middle)},
            (material.shines_behind ? 2 : 1) * pi * A * double(mean(L)));
    }
    for (std::size_t i = 0; i < scene.balls.size(); ++i) {
        const auto& [sphere, material] = scene.balls[i];
        const Spectrum L               = scene.materials[material].emission;
        if (L == Spectrum{}) continue;
        of_surface_[scene.mesh.faces.size() + i] = std::int32_t(emitters_.size());
        add(Globe{{Vec3(sphere.centre), float(sphere.radius)}, L},
            4 * square(pi * sphere.radius) * double(mean(L)));
    }
    if (scene.background != Spectrum{}) {
        sky_ = std::int32_t(emitters_.size());
        add(Sky{scene.background},
            4 * square(pi) * squared_radius_of(scene) * double(mean(scene.background)));
    }
    if (!powers_.empty()) choice_.emplace(powers_);
}

void Emitters::add(const Emitter& emitter, double power) {
    emitters_.push_back(emitter);
    powers_.push_back(power);
}

std::optional<LightSample> Emitters::sample(const SurfacePoint<float>& from, Vec2 u) const {
    if (!choice_) return std::nullopt;
    const auto  one   = choice_->choose(double(u.x));
    const float again = std::min(float(one.share), largest_below_1<float>);
    auto        light = std::visit(
        [&](const auto& emitter) {
            return drawn(emitter, from, {again, u.y});
        },
        emitters_[one.index]);
    if (!light) return std::nullopt;
    light->arriving = light->arriving / float(one.probability);
    light->pdf.value *= one.probability;
    return light;
}

std::optional<LightSample> Emitters::drawn(const PointLight& light, const SurfacePoint<float>& from,
                                           Vec2) const {
    const Vec3 position(light.position());
    const Vec3 way = position - from.position;
    return LightSample{between(from, position),
                       before_the_end<float>,
                       normalize(way),
                       light.intensity() / dot(way, way),
                       {}};
}

std::optional<LightSample> Emitters::drawn(const Face& face, const SurfacePoint<float>& from, Vec2 u) const {
    const auto& [a, b, c] = face.triangle;
    const Vec3& o         = from.position;
    if (is_in_plane(from, face.triangle, face.normal)) return std::nullopt;
    if (!face.shines_behind && dot(o - a, face.normal) <= 0) return std::nullopt;
    const Vec2 weights =
        by_area(face, o) ? sample_triangle(u) : SphericalTriangle<float>(a - o, b - o, c - o).sample(u);
    const auto point     = surface_point(face.triangle, weights, face.normal);
    const Vec3 direction = normalize(point.position - o);
    const auto p         = density(face, o, direction, point.position);
    if (!(p.value > 0 && std::isfinite(p.value))) return std::nullopt;  // seen from its edge
    return LightSample{between(from, point), before_the_end<float>, direction, face.radiance / float(p.value),
                       p};
}

std::optional<LightSample> Emitters::drawn(const Globe& globe, const SurfacePoint<float>& from,
                                           Vec2 u) const {
    const auto s     = sine_of_cone(globe.sphere, from.position);
    const Vec3 local = s ? sample_cone(u, *s) : sample_uniform_sphere(u);
    const auto p     = s ? pdf_cone(local, *s) : pdf_uniform_sphere(local);
    const Vec3 direction =
        s ? frame_around(normalize(globe.sphere.centre - from.position)).to_world(local) : local;
    const Ray<float> ray{from.position, direction};
    const auto       point = surface_point(globe.sphere, ray, distance_to(globe.sphere, ray));
    return LightSample{between(from, point), before_the_end<float>, direction,
                       globe.radiance / float(p.value), p};
}

std::optional<LightSample> Emitters::drawn(const Sky& sky, const SurfacePoint<float>& from, Vec2 u) const {
    const Vec3 local     = sample_cosine_hemisphere(u);
    const auto p         = pdf_cosine_hemisphere(local);
    const Vec3 direction = frame_around(from.normal).to_world(local);
    return LightSample{leave(from, direction), in_front<float>, direction, sky.radiance / float(p.value), p};
}

bool Emitters::by_area(const Face& face, const Vec3& from) const {
    if (triangles_ != TriangleSampling::by_distance) return triangles_ == TriangleSampling::area;
    const Vec3 way = face.middle - from;
    return dot(way, way) > face.far;
}

Pdf<measure::SolidAngle> Emitters::density(const Face& face, const Vec3& from, const Vec3& direction,
                                           const Vec3& hit) const {
    if (by_area(face, from)) {
        const Vec3 way = hit - from;
        return to_solid_angle(Pdf<measure::Area>{1 / double(face.area)}, double(dot(way, way)),
                              std::abs(double(dot(direction, face.normal))));
    }
    const auto& [a, b, c] = face.triangle;
    return {1 / double(SphericalTriangle<float>(a - from, b - from, c - from).solid_angle())};
}

Pdf<measure::SolidAngle> Emitters::pdf(const SurfacePoint<float>& from, const Vec3& direction,
                                       const SurfaceHit<float>& hit) const {
    const std::int32_t i = of_surface_[hit.surface];
    if (i < 0) return {};
    const double chance = choice_->probability(std::size_t(i));
    if (const auto* face = std::get_if<Face>(&emitters_[std::size_t(i)])) {
        if (is_in_plane(from, face->triangle, face->normal)) return {};
        return {chance * density(*face, from.position, direction, hit.point.position).value};
    }
    const auto s = sine_of_cone(std::get<Globe>(emitters_[std::size_t(i)]).sphere, from.position);
    return {chance * (s ? 1 / (2 * pi * cone_height(double(*s))) : 1 / (4 * pi))};
}

Pdf<measure::SolidAngle> Emitters::pdf_of_background(const SurfacePoint<float>& from,
                                                     const Vec3&                direction) const {
    if (sky_ < 0) return {};
    const float cosine = dot(from.normal, direction);
    return {choice_->probability(std::size_t(sky_)) * (cosine > 0 ? double(cosine) / pi : 0)};
}

}  // namespace sr
