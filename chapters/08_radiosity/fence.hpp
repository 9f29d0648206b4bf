#pragma once
/// @file fence.hpp
/// A fence between a lamp and a floor: shadows that are finer than a mesh. Lengths in units of the floor's side.

#include <cstddef>
#include <vector>

#include "cube_points.hpp"
#include "gather.hpp"
#include "radiosity/exchange_area.hpp"
#include "radiosity/patch_view.hpp"
#include "radiosity/visible_share.hpp"
#include "sampling/stratum.hpp"

namespace sr {

/// A rectangle at a height, its front up or down.
[[nodiscard]] inline Patch level_patch(Interval<double> x, Interval<double> y, double z, bool up) {
    const Patch patch{{x.min, y.min, z}, {x.max, y.min, z}, {x.max, y.max, z}, {x.min, y.max, z}};
    return up ? patch : patch.reversed();
}

/// The lamp, 1 above the middle of the floor; it shines with a radiosity of 800.
[[nodiscard]] inline Patch fence_lamp() {
    return level_patch({0.45, 0.55}, {0.45, 0.55}, 1, false);
}
inline constexpr double fence_light = 0.8 * 800;  ///< times the form factor, what the floor reflects [W/m^2]

/// The floor, n x n patches. Only light that comes straight from the lamp is looked at.
[[nodiscard]] inline Patches fence_floor(int n) {
    return cut(std::vector{Polygon{level_patch({0, 1}, {0, 1}, 0, true), grey(0.8), {}, 0}}, 1.0 / n);
}

/// Eight slats 0.1 above the floor, as wide as the gaps between them.
[[nodiscard]] inline Mesh<double> fence() {
    Mesh<double> mesh;
    for (std::uint32_t slat = 0; slat < 8; ++slat) {
        const double        x = (slat + 0.25) / 8, width = 1.0 / 16;
        const std::uint32_t a     = 4 * slat;
        const Patch         shape = level_patch({x, x + width}, {-1, 2}, 0.1, true);
        for (const auto& corner : shape.corners()) mesh.vertices.push_back(corner);
        mesh.faces.push_back({a, a + 1, a + 2});
        mesh.faces.push_back({a, a + 2, a + 3});
    }
    return mesh;
}

/// The radiosities that the lamp causes.
[[nodiscard]] inline Radiosities lit_through_fence(const Patches& floor, const Visibility& visibility,
                                                   int threads) {
    const Patch lamp = fence_lamp();
    Radiosities radiosities(floor.size());
    for_each_row(floor.size(), {threads}, [&](std::size_t i) {
        const Patch& patch = floor.shapes[i];
        Rng          rng{89, std::int64_t(i), 0, 0};
        radiosities[i] = grey(fence_light * exchange_area(patch, lamp, 1e-3) / patch.area() *
                              visible_share(patch, lamp, visibility, 6, rng));
    });
    return radiosities;
}

/// The mean of the floor's radiosity.
[[nodiscard]] inline double mean_through_fence(int n, const Visibility& visibility, int threads) {
    Running mean;
    for (const auto& B : lit_through_fence(fence_floor(n), visibility, threads)) mean.add(B.r);
    return mean.mean();
}

/// How wrong a floor of n x n patches is, at points.
struct FenceError {
    Estimate constant, interpolated;  ///< relative root mean square
};

/// What 400 points of the floor get from the lamp: 1600 of its points, as far as they are seen.
[[nodiscard]] inline Values seen_through_fence(const std::vector<Vector3<double>>& points,
                                               const Visibility& visibility, int threads) {
    const Patch lamp = fence_lamp(), floor = level_patch({0, 1}, {0, 1}, 0, true);
    Values      values(points.size());
    for_each_row(points.size(), {threads}, [&](std::size_t i) {
        const auto from = floor.surface_point(points[i]);
        Rng        rng{91, std::int64_t(i), 0, 0};
        values[i] = fence_light * contour_form_factor(from.position, from.normal, lamp) *
                    visible_share(from, lamp, visibility, 40, rng);
    });
    return values;
}

/// One point in each of 20 x 20 strata.
[[nodiscard]] inline std::vector<Vector3<double>> points_of_the_floor() {
    std::vector<Vector3<double>> points;
    for (int k = 0; k < 400; ++k) {
        Rng          rng{90, k, 0, 0};
        const double x = rng.uniform<double>(), y = rng.uniform<double>();
        points.emplace_back(in_stratum(k, 20, Vector2<double>{x, y}), 0);
    }
    return points;
}

[[nodiscard]] inline FenceError fence_error(int n, const std::vector<Vector3<double>>& points,
                                            const Values& exact, const Visibility& visibility, int threads) {
    const Patches patches = fence_floor(n);
    const auto    B       = lit_through_fence(patches, visibility, threads);
    const auto    smooth  = interpolated_radiosity(patches, vertex_radiosities(patches, B));
    Running       constant, interpolated, mean;
    for (std::size_t k = 0; k < points.size(); ++k) {
        const auto cell  = [&](double s) { return std::uint32_t(std::min(int(s * n), n - 1)); };
        const auto patch = cell(points[k].y) * std::uint32_t(n) + cell(points[k].x);
        constant.add(square(B[patch].r - exact[k]));
        interpolated.add(square(smooth({patch, points[k]}).r - exact[k]));
        mean.add(exact[k]);
    }
    const auto rms = [&](const Running& squares) {
        const double root = std::sqrt(squares.mean());
        return Estimate{root / mean.mean(), squares.standard_error() / (2 * root) / mean.mean()};
    };
    return {rms(constant), rms(interpolated)};
}

}  // namespace sr
