#pragma once
/// @file visibility_difference.hpp
/// Two images of the same scene by two methods: how many pixels differ, and does each have an excuse?

#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>
#include <limits>

#include "geometry/mesh.hpp"
#include "scene/camera.hpp"
#include "scene/visible.hpp"

namespace sr {

struct VisibilityDifference {
    int pixels         = 0;
    int hit            = 0;  ///< by both
    int hit_or_missed  = 0;  ///< hit by one method, missed by the other
    int other_triangle = 0;  ///< hit by both, in different triangles: each is one of the next three
    int at_edge        = 0;  ///< the pixel's centre lies within edge_tolerance of an edge
    int at_tie         = 0;  ///< not at an edge, but the depths are within tie_tolerance of each other
    int unexplained    = 0;  ///< neither
};

/// How near to an edge, and how nearly tied in depth, a pixel must be for methods to disagree on its triangle.
inline constexpr double edge_tolerance = 1e-5;  ///< [pixel]
inline constexpr double tie_tolerance  = 1e-6;  ///< relative to t

/// The distance [pixel] of a point of the image from the nearest side of a triangle's projection; infinite for
/// a triangle that reaches behind the camera. In double, whatever the images were made in.
template <std::floating_point T>
[[nodiscard]] double distance_to_edge(const Triangle<T>& triangle, Vector2<double> point,
                                      const Camera<T>& camera) {
    const auto                      exact   = convert<double>(camera);
    const std::array<Vector3<T>, 4> corners = {triangle.a, triangle.b, triangle.c, triangle.a};
    double                          nearest = std::numeric_limits<double>::infinity();
    for (std::size_t side = 0; side < 3; ++side) {
        const auto a = exact.project(corners[side]);
        const auto b = exact.project(corners[side + 1]);
        if (!a || !b) return std::numeric_limits<double>::infinity();
        const Vector2<double> along = *b - *a;
        const double          s     = std::clamp(dot(point - *a, along) / dot(along, along), 0.0, 1.0);
        nearest                     = std::min(nearest, length(point - *a - s * along));
    }
    return nearest;
}

/// Compares what two methods see of a mesh through the same camera.
/// @pre both images have the camera's size
template <std::floating_point T>
[[nodiscard]] VisibilityDifference compare_visibility(const VisibilityImage<T>& one,
                                                      const VisibilityImage<T>& other, const Mesh<T>& mesh,
                                                      const Camera<T>& camera) {
    VisibilityDifference result;
    for (int y = 0; y < camera.height; ++y) {
        for (int x = 0; x < camera.width; ++x) {
            const Visible<T> a = one(x, y);
            const Visible<T> b = other(x, y);
            ++result.pixels;
            if (a.hit() != b.hit()) ++result.hit_or_missed;
            if (!a.hit() || !b.hit()) continue;
            ++result.hit;
            if (a.face == b.face) continue;
            ++result.other_triangle;

            const Vector2<double> centre{x + 0.5, y + 0.5};
            const double          edge = std::min(distance_to_edge(mesh.triangle(a.face), centre, camera),
                                                  distance_to_edge(mesh.triangle(b.face), centre, camera));
            const double          tie  = std::abs(double(a.t) - double(b.t)) / double(a.t);
            ++(edge <= edge_tolerance ? result.at_edge
               : tie <= tie_tolerance ? result.at_tie
                                      : result.unexplained);
        }
    }
    return result;
}

}  // namespace sr
