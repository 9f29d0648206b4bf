#pragma once
/// @file attack.hpp
/// Rays at the edges and vertices of a mesh, in front of which no ray should pass.

#include <cmath>
#include <cstdint>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "geometry/neighbours.hpp"
#include "image/image.hpp"
#include "sampling/rng.hpp"
#include "scene/teapot.hpp"
#include "scene/uv_sphere.hpp"
#include "transport/tiles.hpp"

namespace sr {

/// Where a mesh stands, and how large it is.
struct Placement {
    std::string name;
    double      scale  = 1;
    double      offset = 0;  ///< added to x, y and z

    [[nodiscard]] Vector3<double> operator()(Vector3<double> point) const { return scale * point + offset; }
};

/// A mesh under attack, and where rays may come from.
struct Target {
    std::string                          name;
    Mesh<double>                         mesh;
    std::function<Vector3<double>(Rng&)> origin;
    Neighbours                           neighbours{mesh};

    /// Whether no ray from the point may pass at the vertex.
    [[nodiscard]] bool walls_off(std::uint32_t vertex, const Vector3<double>& point) const {
        return sr::walls_off(mesh, neighbours, vertex, point);
    }
};

/// In [-1, 1]^3.
[[nodiscard]] inline Vector3<double> in_cube(Rng& rng) {
    const double x = rng.uniform<double>(), y = rng.uniform<double>(), z = rng.uniform<double>();
    return 2.0 * Vector3<double>{x, y, z} - 1.0;
}

/// The nearest point below whose coordinates are multiples of 1/1024, of which float holds each in all placements.
[[nodiscard]] inline Vector3<double> on_grid(Vector3<double> point) {
    return glm::floor(point * 1024.0) / 1024.0;
}

/// Where the attacks of this chapter take place.
inline const std::vector<Placement> placements{
    {"at the origin"}, {"moved by 100", 1, 100}, {"scaled by 3/4096", 3.0 / 4096}};

/// The closed sphere of 528 triangles, from inside.
[[nodiscard]] inline Target sphere_from_inside() {
    return {"sphere", uv_sphere(12), [](Rng& rng) { return on_grid(0.4 * in_cube(rng)); }};
}

/// The teapot of 4032 triangles, from all around.
[[nodiscard]] inline Target teapot_from_outside() {
    return {"teapot", teapot(8), [](Rng& rng) {
                return on_grid(Vector3<double>{0, 0, 1.5} + 8.0 * normalize(in_cube(rng)));
            }};
}

/// A ray from `origin` at the point a + u (b - a) of an edge; at the vertex a where u = 0.
struct Aim {
    Vector3<double> origin;
    std::uint32_t   a, b;
    double          u;
};

/// Of a share [%] that was counted over so many rays [%].
[[nodiscard]] inline double standard_error(double percent, std::size_t rays) {
    return std::sqrt(percent * (100 - percent) / double(rays));
}

enum class At { edges, vertices };

/// The ray of this number: it has to hit one of the faces around the edge's ends.
[[nodiscard]] inline Aim aim(const Target& target, At at, int number) {
    Rng rng{3, int(at), 0, number};
    for (;;) {
        const auto  origin = target.origin(rng);
        const auto& face =
            target.mesh.faces[std::size_t(rng.uniform<double>() * double(target.mesh.faces.size()))];
        const auto   corner = std::size_t(rng.uniform() * 3);
        const auto   a = face[corner], b = face[(corner + 1) % 3];
        const double u = at == At::vertices ? 0 : rng.uniform<double>();
        if (target.walls_off(a, origin) && (at == At::vertices || target.walls_off(b, origin)))
            return {origin, a, b, u};
    }
}

/// side x side rays, the same for all methods, precisions and places.
[[nodiscard]] inline Image<Aim> aims(const Target& target, At at, int side, const TileLoop& loop) {
    Image<Aim> result(side, side);
    for_each_pixel(side, side, loop, [&](int x, int y) { result(x, y) = aim(target, at, y * side + x); });
    return result;
}

/// The mesh in its place, rounded to T once.
template <std::floating_point T>
[[nodiscard]] Mesh<T> placed(Mesh<double> mesh, const Placement& place) {
    for (auto& vertex : mesh.vertices) vertex = place(vertex);
    return convert<T>(mesh);
}

/// The aimed ray in T, as near to the edge of the rounded mesh as its direction can tell.
template <std::floating_point T>
[[nodiscard]] Ray<T> placed_ray(const Aim& aim, const Mesh<T>& mesh, const Placement& place) {
    const Vector3<double> a(mesh.vertices[aim.a]), b(mesh.vertices[aim.b]);
    const Vector3<T>      origin(place(aim.origin));
    return {origin, Vector3<T>((a - Vector3<double>(origin)) + aim.u * (b - a))};
}

}  // namespace sr
