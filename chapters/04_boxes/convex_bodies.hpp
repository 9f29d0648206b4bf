#pragma once
/// @file convex_bodies.hpp
/// A convex body is an intersection of half-spaces, of cylinders and of balls: a line's part in it is an
/// intersection of intervals, as with slabs.

#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "geometry/ray.hpp"
#include "math/interval.hpp"
#include "textbook_slabs.hpp"

namespace sr {

/// The points p with n.p <= h.
struct HalfSpace {
    Vector3<double> n;
    double          h;
};

/// A body around the origin, and what is known of it.
struct ConvexBody {
    std::string            name;
    std::vector<HalfSpace> half_spaces = {};
    double                 cylinder    = 0;  ///< its radius about z, where there is one
    double                 ball        = 0;  ///< its radius, where there is one
    double                 volume;
    double                 surface;
    double                 circumradius;
};

/// Cuts the interval to where a t^2 + 2 b t + c <= 0.
/// @pre a >= 0
[[nodiscard]] inline Interval<double> clip_to_quadratic(Interval<double> range, double a, double b,
                                                        double c) {
    const double discriminant = b * b - a * c;
    if (!(discriminant >= 0 && a > 0)) return {1, 0};
    const double root = std::sqrt(discriminant);
    return {std::fmax(range.min, (-b - root) / a), std::fmin(range.max, (-b + root) / a)};
}

/// The part of the line inside.
[[nodiscard]] inline Interval<double> clip(const ConvexBody& body, const Ray<double>& line) {
    const auto& [o, d]     = line;
    Interval<double> range = whole_line<double>;
    for (const auto& [n, h] : body.half_spaces) {
        const double ahead = dot(n, d), t = (h - dot(n, o)) / ahead;
        if (ahead > 0) range.max = std::fmin(range.max, t);
        if (ahead < 0) range.min = std::fmax(range.min, t);
        if (ahead == 0 && !(dot(n, o) <= h)) return {1, 0};
    }
    if (body.cylinder > 0) {
        const Vector2<double> across{o}, along{d};
        range = clip_to_quadratic(range, dot(along, along), dot(across, along),
                                  dot(across, across) - body.cylinder * body.cylinder);
    }
    if (body.ball > 0)
        range = clip_to_quadratic(range, dot(d, d), dot(o, d), dot(o, o) - body.ball * body.ball);
    return range;
}

[[nodiscard]] inline ConvexBody ball_body(double r) {
    return {.name         = "ball",
            .ball         = r,
            .volume       = 4 * std::numbers::pi / 3 * r * r * r,
            .surface      = 4 * std::numbers::pi * r * r,
            .circumradius = r};
}

[[nodiscard]] inline ConvexBody box_body(const std::string& name, Vector3<double> size) {
    const Vector3<double> half = size / 2.0;
    return {.name         = name,
            .half_spaces  = {{{1, 0, 0}, half.x},
                             {{-1, 0, 0}, half.x},
                             {{0, 1, 0}, half.y},
                             {{0, -1, 0}, half.y},
                             {{0, 0, 1}, half.z},
                             {{0, 0, -1}, half.z}},
            .volume       = size.x * size.y * size.z,
            .surface      = 2 * (size.x * size.y + size.y * size.z + size.z * size.x),
            .circumradius = length(half)};
}

/// The regular tetrahedron whose vertices are corners of the cube with this side.
[[nodiscard]] inline ConvexBody tetrahedron_body(double cube_side) {
    const double h = cube_side / 2, edge = cube_side * std::numbers::sqrt2;
    return {.name         = "tetrahedron",
            .half_spaces  = {{{1, 1, 1}, h}, {{1, -1, -1}, h}, {{-1, 1, -1}, h}, {{-1, -1, 1}, h}},
            .volume       = cube_side * cube_side * cube_side / 3,
            .surface      = std::numbers::sqrt3 * edge * edge,
            .circumradius = std::numbers::sqrt3 * h};
}

/// About the z axis.
[[nodiscard]] inline ConvexBody cylinder_body(double r, double height) {
    return {.name         = "cylinder",
            .half_spaces  = {{{0, 0, 1}, height / 2}, {{0, 0, -1}, height / 2}},
            .cylinder     = r,
            .volume       = std::numbers::pi * r * r * height,
            .surface      = 2 * std::numbers::pi * r * (r + height),
            .circumradius = std::hypot(r, height / 2)};
}

}  // namespace sr
