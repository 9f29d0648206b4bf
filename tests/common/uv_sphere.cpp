#include "scene/uv_sphere.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <map>
#include <numbers>
#include <stdexcept>
#include <utility>

using namespace sr;

TEST_CASE("a UV sphere is closed, looks outwards and fills the ball") {
    constexpr int bands = 12;
    const auto    mesh  = uv_sphere(bands);
    CHECK(mesh.faces.size() == 4 * bands * bands - 4 * bands);

    std::map<std::pair<std::uint32_t, std::uint32_t>, int> directed;
    double                                                 volume = 0;
    for (std::size_t face = 0; face < mesh.faces.size(); ++face) {
        for (std::size_t i = 0; i < 3; ++i) ++directed[{mesh.faces[face][i], mesh.faces[face][(i + 1) % 3]}];
        const auto triangle = mesh.triangle(face);
        CHECK(dot(area_vector(triangle), triangle.a + triangle.b + triangle.c) > 0);
        volume += dot(triangle.a, cross(triangle.b, triangle.c)) / 6;
    }
    for (const auto& [edge, count] : directed) {
        CHECK(count == 1);  // its neighbour runs along the edge the other way
        CHECK(directed.contains({edge.second, edge.first}));
    }

    // Slices of the polyhedron are regular 24-gons: with the ring i's radius r_i = sin(pi i / n) and height
    // z_i = cos(pi i / n), a band is the frustum (r_i^2 + r_i r_j + r_j^2) (z_i - z_j) / 3 times the area n sin(pi / n)
    // of the 2n-gon of radius 1; and each band's quadrilaterals are plane, being trapezia.
    const double pi       = std::numbers::pi;
    double       expected = 0;
    for (int i = 0; i < bands; ++i) {
        const double r = std::sin(pi * i / bands), s = std::sin(pi * (i + 1) / bands);
        const double height = std::cos(pi * i / bands) - std::cos(pi * (i + 1) / bands);
        expected += (r * r + r * s + s * s) * height / 3 * bands * std::sin(pi / bands);
    }
    CHECK(std::abs(volume - expected) <= 1e-14 * expected);
}

TEST_CASE("a UV sphere that can't be is refused") {
    for (const int bands : {-1, 0, 1, max_uv_sphere_bands + 1})
        CHECK_THROWS_AS((void)uv_sphere(bands), std::invalid_argument);
    CHECK(uv_sphere(2).faces.size() == 8);
}
