#pragma once
/// @file cube_points.hpp
/// Radiosity as a function of the place, at points of the cube of mixed_cube.hpp.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

#include "mixed_cube.hpp"
#include "sampling/rng.hpp"
#include "statistics/estimate.hpp"
#include "statistics/running.hpp"

namespace sr {

/// A point of a face. Its weight is the area that it stands for, over the mean one.
struct CubePoint {
    std::size_t     face;
    Vector2<double> st;
    double          weight;
};

/// One point in each of 10 x 10 strata of each face, closer to each other towards the edges, where radiosity is least
/// smooth.
[[nodiscard]] inline std::vector<CubePoint> points_of_the_cube() {
    using std::numbers::pi;
    constexpr int          side = 10;
    std::vector<CubePoint> points;
    for (int k = 0; k < 6 * side * side; ++k) {
        Rng          rng{86, k, 0, 0};
        const double x = rng.uniform<double>(), y = rng.uniform<double>();
        const double u = (k % side + x) / side, v = (k / side % side + y) / side;
        points.push_back({std::size_t(k / (side * side)),
                          {(1 - std::cos(pi * u)) / 2, (1 - std::cos(pi * v)) / 2},
                          pi / 2 * std::sin(pi * u) * pi / 2 * std::sin(pi * v)});
    }
    return points;
}

/// Where in a face: within 1/4 of a corner; not there; or not there, but within 1/10 of an edge.
enum class Part { everywhere, near_corners, elsewhere, along_edges };

[[nodiscard]] inline bool lies_in(Part part, const CubePoint& point) {
    const double x = std::min(point.st.x, 1 - point.st.x), y = std::min(point.st.y, 1 - point.st.y);
    const bool   near_corner = std::hypot(x, y) < 0.25;
    switch (part) {
        case Part::near_corners:
            return near_corner;
        case Part::elsewhere:
            return !near_corner;
        case Part::along_edges:
            return !near_corner && std::min(x, y) < 0.1;
        default:
            return true;
    }
}

using Values = std::vector<double>;

/// Each point's radiosity: that of its patch, interpolated in it, or gathered from all patches.
enum class Within { constant, interpolated, gathered };

[[nodiscard]] inline double value_at(const CubePoint& point, const CubeSolution& cube, Within within) {
    static const auto faces = mixed_cube();
    const auto&       face  = faces[point.face];
    const auto        p     = face.shape.at(point.st);
    if (within == Within::gathered)
        return gathered({face.shape.surface_point(p), face.reflectance, face.emission}, cube.patches,
                        cube.radiosities)
            .r;
    const auto        cell  = [&](double s) { return std::size_t(std::min(int(s * cube.n), cube.n - 1)); };
    const std::size_t n     = std::size_t(cube.n);
    const std::size_t patch = (point.face * n + cell(point.st.y)) * n + cell(point.st.x);
    return within == Within::constant ? cube.radiosities[patch].r
                                      : interpolated(cube.patches, cube.at_vertices, patch, p).r;
}

[[nodiscard]] inline Values values_at(const std::vector<CubePoint>& points, const CubeSolution& cube,
                                      Within within, int threads) {
    Values values(points.size());
    for_each_row(points.size(), {threads},
                 [&](std::size_t i) { values[i] = value_at(points[i], cube, within); });
    return values;
}

/// The continuous solution: gathered from 8 x 8 and from 16 x 16 patches a face, each seen from its centre, and
/// extrapolated to none: its error falls as their area.
[[nodiscard]] inline Values reference_at(const std::vector<CubePoint>& points, const CubeSolution& coarse,
                                         const CubeSolution& fine, int threads) {
    const Values at_coarse = values_at(points, coarse, Within::gathered, threads);
    Values       values    = values_at(points, fine, Within::gathered, threads);
    const double finer     = square(double(fine.n) / coarse.n);
    for (std::size_t i = 0; i < values.size(); ++i) values[i] += (values[i] - at_coarse[i]) / (finer - 1);
    return values;
}

/// The root of the mean square error over a part of all faces, as a share of the mean radiosity there.
[[nodiscard]] inline Estimate relative_rms(const std::vector<CubePoint>& points, const Values& values,
                                           const Values& exact, Part part) {
    Running squares, mean;
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (!lies_in(part, points[i])) continue;
        squares.add(points[i].weight * square(values[i] - exact[i]));
        mean.add(points[i].weight * exact[i]);
    }
    const double rms = std::sqrt(squares.mean());
    return {rms / mean.mean(), squares.standard_error() / (2 * rms) / mean.mean()};
}

}  // namespace sr
