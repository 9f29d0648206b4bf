#pragma once
/// @file optics.hpp
/// An optical bench in the plane z = 0: rays through glass with flat and with round faces, traced by the core's own
/// intersections, reflections and refractions, in double. Lengths are in one unit, angles in radians.

#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <vector>

#include "geometry/plane.hpp"
#include "geometry/sphere.hpp"
#include "material/fresnel.hpp"
#include "math/angle.hpp"
#include "math/bracketed_root.hpp"
#include "transport/interaction.hpp"

namespace sr {

/// What became of a ray: itself, and after each surface what left it. The last one goes on for ever.
using LightPath = std::vector<Ray<double>>;

/// The direction at an angle to the x axis.
[[nodiscard]] inline Vector3<double> heading(double angle) {
    return {std::cos(angle), std::sin(angle), 0};
}

/// The angle by which light was turned, 0 to pi.
[[nodiscard]] inline double deviation(const LightPath& path) {
    return angle_between(normalize(path.front().direction), normalize(path.back().direction));
}

/// Where a ray, or its extension backwards, crosses the x axis.
[[nodiscard]] inline double axis_crossing(const Ray<double>& ray) {
    return ray.at(-ray.origin.y / ray.direction.y).x;
}

/// Through one face after the other; normals look out of the glass. None if a face is missed, or reflects totally.
[[nodiscard]] inline std::optional<LightPath> through_faces(const Ray<double>&                ray,
                                                            const std::vector<Plane<double>>& faces,
                                                            double                            n) {
    LightPath path{ray};
    for (const auto& face : faces) {
        const auto t = intersect(face, path.back());
        if (!t) return std::nullopt;
        const auto next = refracted(path.back(), surface_point(face, path.back(), *t), n);
        if (!next) return std::nullopt;
        path.push_back(*next);
    }
    return path;
}

/// Into a ball, reflected inside so many times, and out again. None if the ball is missed.
[[nodiscard]] inline std::optional<LightPath> through_ball(const Ray<double>& ray, const Sphere<double>& ball,
                                                           double n, int reflections = 0) {
    LightPath path{ray};
    for (int face = 0; face < reflections + 2; ++face) {
        const Ray<double> here = path.back();
        const auto        t    = intersect(ball, here);
        if (!t) return std::nullopt;
        const auto point = surface_point(ball, here, *t);
        const bool turns = face > 0 && face <= reflections;
        const auto next  = turns ? std::optional(reflected(here, point)) : refracted(here, point, n);
        if (!next) return std::nullopt;
        path.push_back(*next);
    }
    return path;
}

/// A prism with its apex, of the angle A, up: the ray meets the left face at an angle of incidence and leaves by the
/// right one.
struct Prism {
    double A = std::numbers::pi / 3;
    double n = 1.5;

    [[nodiscard]] Vector3<double> left() const { return heading(std::numbers::pi - A / 2); }
    [[nodiscard]] Vector3<double> right() const { return heading(A / 2); }

    /// @param incidence  to the normal of the left face, from the side of the base
    [[nodiscard]] std::optional<LightPath> trace(double incidence) const {
        const Vector3<double> apex{0, 1, 0}, entry = apex - heading(std::numbers::pi / 2 - A / 2);
        const auto            d = heading(incidence - A / 2);
        return through_faces({entry - d, d}, {{apex, left()}, {apex, right()}}, n);
    }

    /// How much larger the angle at which light leaves is than that at which it came: 0 where the way is symmetric.
    [[nodiscard]] double asymmetry(double incidence) const {
        const auto path = trace(incidence);
        return path ? angle_between(path->back().direction, right()) - incidence
                    : std::numeric_limits<double>::quiet_NaN();
    }
};

/// Where a ray that comes along the axis, at a height, crosses it behind a ball around the origin.
[[nodiscard]] inline double ball_lens_crossing(double height, double radius, double n) {
    const auto path = through_ball({{-3 * radius, height, 0}, {1, 0, 0}}, {{0, 0, 0}, radius}, n);
    return path ? axis_crossing(path->back()) : std::numeric_limits<double>::quiet_NaN();
}

/// A ray along the axis that a hollow mirror, the sphere around the origin, sends back.
[[nodiscard]] inline LightPath off_hollow_mirror(double height, double radius) {
    const Ray<double>    ray{{0, height, 0}, {1, 0, 0}};
    const Sphere<double> mirror{{0, 0, 0}, radius};
    const auto           t = intersect(mirror, ray);
    return t ? LightPath{ray, reflected(ray, surface_point(mirror, ray, *t))} : LightPath{ray};
}

/// A drop of water of radius 1, and a ray of sunlight that passes its centre at the distance b.
[[nodiscard]] inline std::optional<LightPath> through_drop(double b, double n, int reflections = 1) {
    return through_ball({{-3, b, 0}, {1, 0, 0}}, {{0, 0, 0}, 1}, n, reflections);
}

/// The argument at which f is least, between two where it has one valley: thirds are cut off.
template <class F>
[[nodiscard]] double least_at(const F& f, double low, double high) {
    for (int step = 0; step < 100; ++step) {
        const double third = (high - low) / 3;
        if (f(low + third) < f(high - third))
            high -= third;
        else
            low += third;
    }
    return (low + high) / 2;
}

/// A surface of water of index n at y = 0; a ray that meets it in the origin, at an angle to the vertical, from above
/// or from below.
[[nodiscard]] inline std::optional<LightPath> through_water_level(double angle, bool from_above, double n) {
    const double          down = from_above ? -1 : 1;
    const Vector3<double> d{std::sin(angle), down * std::cos(angle), 0};
    return through_faces({-d, d}, {{{0, 0, 0}, {0, 1, 0}}}, n);
}

/// The largest angle to the vertical at which light from below leaves the water.
[[nodiscard]] inline double critical_angle(double n) {
    const auto leaves = [&](double angle) { return through_water_level(angle, false, n) ? 1.0 : -1.0; };
    return bisect(leaves, Interval<double>{0, std::numbers::pi / 2}).value_or(0);
}

/// The angle of incidence at which what is reflected and what is refracted go off at right angles.
[[nodiscard]] inline double right_angle_at(double n) {
    const auto cosine = [&](double angle) {
        const Vector3<double> d{std::sin(angle), -std::cos(angle), 0};
        const auto            below = through_water_level(angle, true, n);
        return below ? dot(Vector3<double>{d.x, -d.y, 0}, below->back().direction) : -1.0;
    };
    return bracketed_root(cosine, Interval<double>{0.1, 1.5}).value_or(0);
}

/// How deep a point seems to be whose light leaves the water at an angle to the vertical: where the ray that is seen,
/// drawn on below, passes under or over it. Its true depth is 1.
[[nodiscard]] inline double apparent_depth(double angle, double n) {
    const auto path = through_water_level(angle, true, n);
    if (!path) return std::numeric_limits<double>::quiet_NaN();
    const Ray<double> below = path->back();
    const double      x     = below.at((-1 - below.origin.y) / below.direction.y).x;
    return x / std::tan(angle);
}

/// How far a plate of thickness 1 moves a ray sideways.
[[nodiscard]] inline double plate_offset(double angle, double n) {
    const auto path = through_faces({-heading(angle), heading(angle)},
                                    {{{0, 0, 0}, {-1, 0, 0}}, {{1, 0, 0}, {1, 0, 0}}}, n);
    if (!path) return std::numeric_limits<double>::quiet_NaN();
    return length(cross(path->back().origin, heading(angle)));
}

}  // namespace sr
