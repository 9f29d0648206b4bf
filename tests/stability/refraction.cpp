/// @file refraction.cpp
/// Where refraction ends and total reflection begins, row S46, and light that stays inside. What is asked is asked by
/// chapter 7 as well.

#include <doctest/doctest.h>

#include <array>
#include <cmath>

#include "../../chapters/07_recursion/border.hpp"
#include "../../chapters/07_recursion/inside_glass.hpp"
#include "catalogue.hpp"
#include "material/dielectric.hpp"
#include "scene/surfaces.hpp"
#include "transport/interaction.hpp"

using namespace sr;
using test::within_factor_3;

TEST_CASE(
    "S46: at the border of total reflection the root is NaN for half of the angles; the core has none") {
    constexpr int angles = 100'000;
    for (const double distance : {1e-6, 1e-5, 1e-4}) {
        const auto count = count_at_border(distance, angles);
        CHECK(within_factor_3(count.school_is_nan / double(angles), 0.5));
        CHECK(count.core_is_wrong == 0);
    }

    // Nor is light lost or won there.
    const Dielectric<float> glass{1.5F};
    for (int i = -1000; i <= 1000; ++i) {
        const double theta = std::asin(1 / 1.5) + 1e-7 * i;
        const auto   both  = glass.branches(Vec3(Vector3<double>{std::sin(theta), 0, -std::cos(theta)}),
                                            TransportMode::importance);
        const float  R     = both.reflected.weight;
        CHECK(std::abs(R + (both.refracted ? both.refracted->weight : 0) - 1) <= 1e-6F);
    }
}

TEST_CASE(
    "inside glass: a fixed epsilon loses light in small balls and in large ones; an error bound in none") {
    constexpr int rays = 5000;
    for (const float radius : {1e-4F, 1e-3F, 1e-2F, 1.0F, 1e2F, 1e3F, 1e4F}) {
        CAPTURE(radius);
        CHECK(count_inside(radius, rays, 2, leave_by_error_bound).astray == 0);
        const double lost = count_inside(radius, rays, 2, leave_by_fixed_epsilon).astray / double(rays);
        // A chord 2 r cos, cos uniform, is shorter than epsilon with probability epsilon / 2 r.
        if (radius < 1e-3F) CHECK(std::abs(lost - 0.5) <= 5 * 0.5 / std::sqrt(double(rays)));
        if (radius >= 1e2F) CHECK(lost >= 0.1);
    }
}

TEST_CASE("inside glass: light that is reflected in a cube of triangles stays there, at any scale") {
    // From corner 0 on: x fastest. Two triangles for each side, whose fronts look outwards.
    const std::array<std::array<std::uint32_t, 4>, 6> sides{
        {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}};
    for (const double scale : {1e-4, 1e-2, 1.0, 1e2, 1e4}) {
        CAPTURE(scale);
        Scene scene;
        scene.materials = {{"glass", LobeSum<float>{{{{1, 1, 1}, Dielectric<float>{1.5F}}}}}};
        for (int i = 0; i < 8; ++i)
            scene.mesh.vertices.push_back(scale * Vector3<double>{7 + i % 2, 5 + i / 2 % 2, 3 + i / 4});
        for (const auto& [a, b, c, d] : sides) {
            scene.mesh.faces.push_back({a, b, c});
            scene.mesh.faces.push_back({a, c, d});
        }
        scene.material_of_face.assign(12, 0);
        const Surfaces<float> cube(scene);
        int                   escaped = 0, stuck = 0;
        for (int i = 0; i < 500; ++i) {
            Rng        rng{12, i, 0, 0};
            Ray<float> ray{float(scale) * Vec3{7.5F, 5.5F, 3.5F}, normalize(in_unit_ball<float>(rng))};
            Vec3       before{0, 0, 0};
            for (int bounce = 0; bounce < 100; ++bounce) {
                const auto hit = cube.nearest(ray);
                if (!hit) {
                    ++escaped;
                    break;
                }
                stuck += hit->point.normal == before ? 1 : 0;  // the same side twice
                before = hit->point.normal;
                ray    = reflected(ray, hit->point);
            }
        }
        CHECK(escaped == 0);
        CHECK(stuck == 0);
    }
}
