#pragma once
/// @file rasteriser.hpp
/// The z-buffer: for each triangle, which pixels does it cover? The loops of a ray tracer, swapped.

#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>
#include <cstdint>
#include <optional>

#include "geometry/mesh.hpp"
#include "math/difference_of_products.hpp"
#include "scene/camera.hpp"
#include "scene/visible.hpp"

namespace sr {

/// A triangle prepared for all pixels at once. For a pixel's direction d, the products of d with the normals
/// of the three planes through the pinhole and an edge are the weights of the opposite vertices: the pixel is
/// covered where none is negative, equation (1.6). Nothing is divided by a depth, so a triangle that reaches
/// behind the camera needs no clipping.
///
/// The set-up is done in double for either T: it runs once a triangle, and hardware takes the same care, in
/// fixed point.
/// @see Olano & Greer, Triangle Scan Conversion using 2D Homogeneous Coordinates, Graphics Hardware 1997
class TriangleSetup {
public:
    using Vector = Vector3<double>;

    /// A triangle in camera space. None if it is seen edge-on or has no area.
    [[nodiscard]] static std::optional<TriangleSetup> of(const Triangle<double>& seen,
                                                         double                  plane_distance) {
        const auto& [a, b, c] = seen;
        TriangleSetup setup{{accurate_cross(b, c), accurate_cross(c, a), accurate_cross(a, b)},
                            Vector(a.z, b.z, c.z) / plane_distance};
        const double  volume = dot(a, setup.weight_[0]);
        if (!(volume != 0)) return std::nullopt;
        if (volume < 0) {
            for (auto& normal : setup.weight_) normal = -normal;
        }
        return setup;
    }

    /// The t at which the ray with direction d from the pinhole meets the triangle, if it does.
    [[nodiscard]] std::optional<double> t(Vector d) const {
        const double a   = dot(weight_[0], d);
        const double b   = dot(weight_[1], d);
        const double c   = dot(weight_[2], d);
        const double sum = a + b + c;
        if (!(a >= 0 && b >= 0 && c >= 0 && sum > 0)) return std::nullopt;
        return (a * depth_.x + b * depth_.y + c * depth_.z) / sum;
    }

private:
    TriangleSetup(std::array<Vector, 3> weight, Vector depth) : weight_(weight), depth_(depth) {}

    /// p x q, accurate, and to the bit the negative of q x p: the triangle on the other side of an edge sees
    /// exactly the opposite weight, so that two neighbours can't both find a pixel beyond their edge.
    static Vector accurate_cross(Vector p, Vector q) {
        const auto difference = [](double a, double b, double c, double d) {
            return (difference_of_products(a, b, c, d) - difference_of_products(c, d, a, b)) / 2;
        };
        return {difference(p.y, q.z, p.z, q.y), difference(p.z, q.x, p.x, q.z),
                difference(p.x, q.y, p.y, q.x)};
    }

    std::array<Vector, 3> weight_;
    Vector                depth_;  ///< of the vertices, in units of the image plane's distance
};

/// A rectangle of pixels, upper ends excluded.
struct PixelRange {
    int x_begin, y_begin, x_end, y_end;
};

/// The pixels that a triangle can cover: around its projected vertices, or all if it reaches behind the camera.
[[nodiscard]] inline PixelRange pixels_around(const Triangle<double>& triangle,
                                              const Camera<double>&   camera) {
    PixelRange range{camera.width, camera.height, 0, 0};
    for (const auto& vertex : {triangle.a, triangle.b, triangle.c}) {
        const auto image = camera.project(vertex);
        if (!image) return {0, 0, camera.width, camera.height};
        const auto clamped = [](double value, int size) { return int(std::clamp(value, 0.0, double(size))); };
        // A pixel more on each side than the projection says, for its rounding.
        range.x_begin = std::min(range.x_begin, clamped(image->x - 1, camera.width));
        range.y_begin = std::min(range.y_begin, clamped(image->y - 1, camera.height));
        range.x_end   = std::max(range.x_end, clamped(image->x + 2, camera.width));
        range.y_end   = std::max(range.y_end, clamped(image->y + 2, camera.height));
    }
    return range;
}

/// What is seen through each pixel, one triangle after the other. Of equal t the lower face wins, as it does
/// for rays.
template <std::floating_point T>
[[nodiscard]] VisibilityImage<T> rasterise(const Mesh<T>& mesh, const Camera<T>& camera) {
    VisibilityImage<T>   image(camera.width, camera.height);
    const Camera<double> exact     = convert<double>(camera);
    const Camera<double> canonical = in_camera_space(exact);
    for (std::uint32_t face = 0; face < mesh.faces.size(); ++face) {
        const auto [a, b, c] = mesh.triangle(face);
        const Triangle<double> seen{exact.to_camera(a), exact.to_camera(b), exact.to_camera(c)};
        const auto             setup = TriangleSetup::of(seen, camera.plane_distance);
        if (!setup) continue;
        const PixelRange range = pixels_around(seen, canonical);
        for (int y = range.y_begin; y < range.y_end; ++y) {
            for (int x = range.x_begin; x < range.x_end; ++x) {
                const auto t = setup->t(canonical.ray_through_pixel(x, y).direction);
                if (t && T(*t) < image(x, y).t) image(x, y) = {T(*t), face};
            }
        }
    }
    return image;
}

}  // namespace sr
