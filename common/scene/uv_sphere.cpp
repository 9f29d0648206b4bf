/// @file uv_sphere.cpp

#include "scene/uv_sphere.hpp"

#include <fmt/core.h>

#include <cmath>
#include <cstdint>
#include <numbers>
#include <stdexcept>

namespace sr {

Mesh<double> uv_sphere(int bands) {
    if (bands < 2 || bands > max_uv_sphere_bands)
        throw std::invalid_argument(
            fmt::format("UV sphere of {} bands: must be 2 to {}", bands, max_uv_sphere_bands));
    const auto n = std::uint32_t(bands), columns = 2 * n;

    Mesh<double> mesh;
    mesh.vertices.emplace_back(0, 0, 1);
    for (std::uint32_t i = 1; i < n; ++i) {
        for (std::uint32_t j = 0; j < columns; ++j) {
            const double theta = std::numbers::pi * i / n, phi = std::numbers::pi * j / n;
            mesh.vertices.emplace_back(std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi),
                                       std::cos(theta));
        }
    }
    mesh.vertices.emplace_back(0, 0, -1);

    const auto ring  = [&](std::uint32_t i, std::uint32_t j) { return 1 + (i - 1) * columns + j % columns; };
    const auto south = std::uint32_t(mesh.vertices.size() - 1);
    for (std::uint32_t j = 0; j < columns; ++j) {
        mesh.faces.push_back({0, ring(1, j), ring(1, j + 1)});
        mesh.faces.push_back({south, ring(n - 1, j + 1), ring(n - 1, j)});
        for (std::uint32_t i = 1; i + 1 < n; ++i) {
            mesh.faces.push_back({ring(i, j), ring(i + 1, j), ring(i + 1, j + 1)});
            mesh.faces.push_back({ring(i, j), ring(i + 1, j + 1), ring(i, j + 1)});
        }
    }
    return mesh;
}

}  // namespace sr
