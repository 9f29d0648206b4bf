#pragma once
/// @file race.hpp
/// What each method costs, and how exact its t is.

#include <array>
#include <cmath>
#include <concepts>
#include <string>
#include <vector>

#include "attack.hpp"
#include "course/timing.hpp"
#include "leaks.hpp"
#include "methods.hpp"
#include "statistics/running.hpp"

namespace sr {

template <std::floating_point T>
inline constexpr const char* precision_name = sizeof(T) == sizeof(float) ? "float" : "double";

/// The sphere with vertices on a grid so coarse that T holds every number below exactly: the points of its faces whose
/// weights are multiples of 1/16, and the directions there.
template <std::floating_point T>
[[nodiscard]] Mesh<double> sphere_on_grid() {
    constexpr double per_unit = sizeof(T) == sizeof(float) ? 0x1p10 : 0x1p36;
    auto             mesh     = uv_sphere(12);
    for (auto& vertex : mesh.vertices) vertex = glm::floor(vertex * per_unit) / per_unit;
    return mesh;
}

/// A ray from inside at a point of a face: t = 1.
[[nodiscard]] inline Ray<double> exact_ray(const Mesh<double>& mesh, int number) {
    Rng          rng{4, 0, 0, number};
    const auto   origin   = on_grid(0.4 * in_cube(rng));
    const auto   triangle = mesh.triangle(std::size_t(rng.uniform<double>() * double(mesh.faces.size())));
    const double b1       = std::floor(1 + 14 * rng.uniform<double>()) / 16;
    const double b2       = std::floor(1 + (15 - 16 * b1) * rng.uniform<double>()) / 16;
    return {origin, triangle.a + b1 * (triangle.b - triangle.a) + b2 * (triangle.c - triangle.a) - origin};
}

/// The same in another place.
template <std::floating_point T>
[[nodiscard]] std::vector<Ray<T>> exact_rays(const Mesh<double>& mesh, const Placement& place, int count) {
    std::vector<Ray<T>> rays;
    for (int i = 0; i < count; ++i) {
        const auto ray = exact_ray(mesh, i);
        rays.push_back({Vector3<T>(place(ray.origin)), Vector3<T>(place.scale * ray.direction)});
    }
    return rays;
}

/// Asks all triangles for each ray, and hands on each hit.
template <class Method, std::floating_point T>
void ask_all(const std::vector<typename Method::ReadyTriangle>& triangles, const std::vector<Ray<T>>& rays,
             const auto& on_hit) {
    for (const auto& ray : rays) {
        const typename Method::ReadyRay ready(ray);
        for (const auto& triangle : triangles) {
            if (const auto hit = Method::intersect(triangle, ready, in_front<T>)) on_hit(*hit);
        }
    }
}

/// Of each method, in the order of `for_each_method`, |t - 1|.
using ErrorsOfT = std::array<Running, method_count>;

/// On the sphere, of rays whose t is 1.
template <std::floating_point T>
[[nodiscard]] ErrorsOfT t_errors(const Placement& place) {
    const auto  exact = sphere_on_grid<T>();
    const auto  mesh  = placed<T>(exact, place);
    const auto  rays  = exact_rays<T>(exact, place, 1000);
    ErrorsOfT   errors;
    std::size_t number = 0;
    for_each_method<T>([&]<class Method>(Method) {
        auto& of_method = errors[number++];
        ask_all<Method>(made_ready<Method>(mesh), rays,
                        [&](const Hit<T>& hit) { of_method.add(std::abs(double(hit.t) - 1)); });
    });
    return errors;
}

/// The methods in T, as work for the clock; each asks all 528 triangles for each of so many rays.
template <std::floating_point T>
void add_work(std::vector<course::Work>& all, int count, double& kept) {
    const auto exact = sphere_on_grid<T>();
    const auto mesh  = placed<T>(exact, placements.front());
    const auto rays  = exact_rays<T>(exact, placements.front(), count);
    for_each_method<T>([&]<class Method>(Method) {
        all.push_back({Method::name, [triangles = made_ready<Method>(mesh), rays, &kept] {
                           ask_all<Method>(triangles, rays,
                                           [&](const Hit<T>& hit) { kept += double(hit.t); });
                       }});
    });
}

}  // namespace sr
