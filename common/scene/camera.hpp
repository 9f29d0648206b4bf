#pragma once
/// @file camera.hpp
/// The pinhole camera: which ray belongs to a point of the image, and which point of the image to a point of
/// the scene.

#include <cmath>
#include <concepts>
#include <optional>

#include "geometry/mesh.hpp"
#include "geometry/ray.hpp"
#include "math/vector.hpp"

namespace sr {

/// A pinhole at `position` and an image plane before it. Lengths in the plane are counted in pixels, x to the
/// right and y downwards from the top left corner: pixel (i, j) is the square [i, i+1] x [j, j+1], and what
/// is seen through it is what is seen through its centre (i + 1/2, j + 1/2).
/// @pre right, up and forward are unit vectors at right angles
template <std::floating_point T>
struct Camera {
    Vector3<T> position;
    Vector3<T> right;
    Vector3<T> up;
    Vector3<T> forward;
    int        width;           ///< [pixel]
    int        height;          ///< [pixel]
    T          plane_distance;  ///< from the pinhole to the image plane, in pixels: focal length / pixel side

    /// The ray through a point of the image, equation (1.2). Its direction ends in the image plane, so that
    /// t = 1 there and t is the depth along `forward` in units of the plane's distance.
    [[nodiscard]] Ray<T> ray(Vector2<T> image) const {
        const T x = image.x - T(width) / 2;
        const T y = T(height) / 2 - image.y;
        return {position, x * right + y * up + plane_distance * forward};
    }

    [[nodiscard]] Ray<T> ray_through_pixel(int i, int j) const { return ray({T(i) + T(0.5), T(j) + T(0.5)}); }

    /// A point of the scene in the camera's own axes: right, up, forward.
    [[nodiscard]] Vector3<T> to_camera(Vector3<T> point) const {
        const Vector3<T> d = point - position;
        return {dot(d, right), dot(d, up), dot(d, forward)};
    }

    /// Where a point of the scene appears, equation (1.3), inside the image or not; none for points that are
    /// not in front of the pinhole.
    [[nodiscard]] std::optional<Vector2<T>> project(Vector3<T> point) const {
        const Vector3<T> p = to_camera(point);
        if (!(p.z > 0)) return std::nullopt;
        return Vector2<T>{T(width) / 2 + plane_distance * p.x / p.z,
                          T(height) / 2 - plane_distance * p.y / p.z};
    }
};

/// A camera that looks along `direction` with `up` upwards in the image. Pixels are square; `film_width` is
/// the width of the image in the unit of `focal_length`.
/// @pre direction and up are not parallel, lengths and sizes are positive
template <std::floating_point T>
[[nodiscard]] Camera<T> pinhole_camera(Vector3<T> position, Vector3<T> direction, Vector3<T> up,
                                       T focal_length, T film_width, int width, int height) {
    const Vector3<T> forward = normalize(direction);
    const Vector3<T> right   = normalize(cross(forward, up));
    return {
        position, right, cross(right, forward), forward, width, height, focal_length / film_width * T(width)};
}

/// The full angle [rad] over which `pixels` of the image's width or height extend.
template <std::floating_point T>
[[nodiscard]] T field_of_view(const Camera<T>& camera, int pixels) {
    return 2 * std::atan(T(pixels) / 2 / camera.plane_distance);
}

/// The same camera in another precision; each number is rounded once.
template <std::floating_point To, std::floating_point From>
[[nodiscard]] Camera<To> convert(const Camera<From>& camera) {
    return {Vector3<To>(camera.position),
            Vector3<To>(camera.right),
            Vector3<To>(camera.up),
            Vector3<To>(camera.forward),
            camera.width,
            camera.height,
            To(camera.plane_distance)};
}

/// The scene moved and turned so that the camera stands in the origin and looks along z.
template <std::floating_point T>
[[nodiscard]] Mesh<T> to_camera_space(Mesh<T> mesh, const Camera<T>& camera) {
    for (auto& vertex : mesh.vertices) vertex = camera.to_camera(vertex);
    return mesh;
}

/// The same camera, standing in the origin and looking along z.
template <std::floating_point T>
[[nodiscard]] Camera<T> in_camera_space(Camera<T> camera) {
    camera.position = {0, 0, 0};
    camera.right    = {1, 0, 0};
    camera.up       = {0, 1, 0};
    camera.forward  = {0, 0, 1};
    return camera;
}

}  // namespace sr
