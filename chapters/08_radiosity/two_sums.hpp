#pragma once
/// @file two_sums.hpp
/// The irradiance at a point of a room's floor, summed up over directions and over surfaces. The room is a unit cube
/// whose faces have one radiosity each.

#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "math/gauss_legendre.hpp"
#include "math/square.hpp"
#include "math/vector.hpp"
#include "sampling/hemisphere.hpp"
#include "sampling/rng.hpp"
#include "statistics/running.hpp"

namespace sr {

/// Radiosities of the faces -x, x, -y, y and of the ceiling [W/m^2].
using RoomFaces = std::array<double, 5>;

/// The face that a ray from the floor meets.
[[nodiscard]] inline std::size_t face_towards(const Vector3<double>& p, const Vector3<double>& w) {
    const auto   distance = [&](int axis) { return ((w[axis] > 0 ? 1 : 0) - p[axis]) / w[axis]; };
    const double x = distance(0), y = distance(1), z = distance(2);
    if (z <= x && z <= y) return 4;
    if (x <= y) return w.x > 0 ? 1 : 0;
    return w.y > 0 ? 3 : 2;
}

/// (8.1) with L = B / pi: directions by their cosine, so that each counts as the B that it finds.
[[nodiscard]] inline Running irradiance_over_directions(const RoomFaces& B, const Vector3<double>& p,
                                                        int rays) {
    Running sum;
    for (int i = 0; i < rays; ++i) {
        Rng          rng{8, i, 0, 0};
        const double u = rng.uniform<double>(), v = rng.uniform<double>();
        sum.add(B[face_towards(p, sample_cosine_hemisphere(Vector2<double>{u, v}))]);
    }
    return sum;
}

/// (8.3) without its reflectance: Gauss and Legendre's points on each face.
[[nodiscard]] inline double irradiance_over_surfaces(const RoomFaces& B, const Vector3<double>& p) {
    const auto rule = gauss_legendre(64, 0, 1);
    double     sum  = 0;
    for (std::size_t face = 0; face < B.size(); ++face) {
        const int    axis = int(face / 2);
        const double at   = face == 4 ? 1.0 : double(face % 2);
        for (const auto& u : rule) {
            for (const auto& v : rule) {
                Vector3<double> x;
                x[axis]              = at;
                x[(axis + 1) % 3]    = u.x;
                x[(axis + 2) % 3]    = v.x;
                const auto   to      = x - p;
                const double r2      = dot(to, to);
                const double cosines = to.z * std::abs(to[axis]) / r2;
                sum += B[face] * cosines / (std::numbers::pi * r2) * u.weight * v.weight;
            }
        }
    }
    return sum;
}

}  // namespace sr
