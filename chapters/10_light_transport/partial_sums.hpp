#pragma once
/// @file partial_sums.hpp
/// Section 10.5: the same partial sums of (10.17) by three programs: rays k deep, k steps of Jacobi, paths of fewer
/// than k bounces. The scene is a cube whose faces all emit 1 and reflect the same colour.

#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

#include "radiosity/closed_form_factors.hpp"
#include "radiosity/relaxed_jacobi.hpp"
#include "sampling/random_point.hpp"
#include "scene/small_scenes.hpp"
#include "transport/path_tracer.hpp"
#include "transport/recursion.hpp"

namespace sr {

inline constexpr Spectrum   room_reflectance{0.8F, 0.5F, 0.2F};
inline constexpr Ray<float> into_the_room{{0.1F, 0.2F, -0.3F}, {0.4F, 1, 0.3F}};

/// The cube, its faces of one lobe.
[[nodiscard]] inline Scene shining_room(const Lobe<float>& lobe) {
    Scene scene;
    scene.materials.assign(6, {"wall", LobeSum<float>{{{room_reflectance, lobe}}}, {1, 1, 1}});
    add_cube(scene, -1, 1);
    return scene;
}

/// Chapter 7, k >= 1: walls are mirrors, and there is nothing to be seen but walls that shine.
[[nodiscard]] inline DoubleSpectrum sum_by_recursion(int k) {
    Rng                   rng{1, 0, 0, 0};
    RayCount              count;
    const RecursiveTracer tracer(shining_room(Mirror<float>{}), {.depth = k});
    return convert<double>(tracer.radiance(into_the_room, rng, count));
}

/// Chapter 8, k >= 1: a patch for each face. It emits pi, so that its radiosity over pi is a radiance.
[[nodiscard]] inline DoubleSpectrum sum_by_jacobi(int k) {
    const double    opposed = opposed_rectangles(1, 1, 1), adjacent = perpendicular_rectangles(1, 1, 1);
    const double    pi = std::numbers::pi;
    RadiositySystem system{FormFactorMatrix(6), std::vector<double>(6, 1),
                           std::vector(6, convert<double>(room_reflectance)), Radiosities(6, {pi, pi, pi})};
    for (std::size_t i = 0; i < 6; ++i)
        for (std::size_t j = 0; j < 6; ++j)
            system.form_factors(i, j) = i == j ? 0 : i / 2 == j / 2 ? opposed : adjacent;
    RelaxedJacobi jacobi(system);
    for (int step = 0; step < k; ++step) jacobi.step();
    return jacobi.radiosities()[0] / pi;
}

/// This chapter, k >= 1. Wherever a path goes, it finds the same light: one is enough.
[[nodiscard]] inline DoubleSpectrum sum_by_paths(int k) {
    const PathTracer tracer(shining_room(Diffuse<float>{}),
                            {.strategy = Strategy::bsdf, .bounces = k - 1, .roulette = k});
    RandomPoint      point(SampleId{});
    PathCount        count;
    return convert<double>(tracer.radiance(into_the_room, point, count));
}

/// (1 - rho^k) / (1 - rho)
[[nodiscard]] inline double partial_sum(double rho, int k) {
    return (1 - std::pow(rho, k)) / (1 - rho);
}

}  // namespace sr
