#pragma once
/// @file leaks.hpp
/// How many rays at edges and vertices hit nothing?

#include <array>
#include <concepts>
#include <cstdint>
#include <vector>

#include "attack.hpp"
#include "image/image.hpp"
#include "methods.hpp"
#include "transport/tiles.hpp"

namespace sr {

/// Of each method, in the order of `for_each_method`, the rays that were lost [%].
using LeakRates = std::array<double, method_count>;

/// Whether the ray hits one of the faces around the edge's ends.
template <class Method, std::floating_point T>
[[nodiscard]] bool is_stopped(const std::vector<typename Method::ReadyTriangle>& triangles,
                              const Neighbours& neighbours, const Aim& aim, const Ray<T>& ray) {
    const typename Method::ReadyRay ready(ray);
    for (const auto end : {aim.a, aim.b}) {
        for (const auto face : neighbours.around(end))
            if (Method::intersect(triangles[face], ready, in_front<T>)) return true;
    }
    return false;
}

/// Attacks the target in T.
template <std::floating_point T>
[[nodiscard]] LeakRates leak_rates(const Target& target, const Placement& place, const Image<Aim>& aims,
                                   const TileLoop& loop) {
    const auto  mesh = placed<T>(target.mesh, place);
    LeakRates   rates{};
    std::size_t method_number = 0;
    for_each_method<T>([&]<class Method>(Method) {
        const auto          triangles = made_ready<Method>(mesh);
        Image<std::uint8_t> lost(aims.width(), aims.height());
        for_each_pixel(lost.width(), lost.height(), loop, [&](int column, int row) {
            const auto ray = placed_ray(aims(column, row), mesh, place);
            lost(column, row) =
                is_stopped<Method>(triangles, target.neighbours, aims(column, row), ray) ? 0 : 1;
        });
        int count = 0;
        for (const auto pixel : lost.pixels()) count += pixel;
        rates[method_number++] = 100.0 * count / double(lost.pixels().size());
    });
    return rates;
}

}  // namespace sr
