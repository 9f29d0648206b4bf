/// @file radiosity_limits.cpp
/// Where radiosity fails: what goes wrong if nobody looks, beside what is done about it. The scenes are those that
/// chapter 8 charts in section 8.9.

#include <doctest/doctest.h>

#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

#include "../../chapters/08_radiosity/aligned_floor.hpp"
#include "../../chapters/08_radiosity/fence.hpp"
#include "../../chapters/08_radiosity/limit_charts.hpp"
#include "../../chapters/08_radiosity/lost_light.hpp"
#include "near.hpp"
#include "radiosity/system_check.hpp"

using namespace sr;
using sr::test::near;

namespace {

std::string refusal(const RadiositySystem& system) {
    try {
        check_system(system);
    } catch (const std::invalid_argument& error) {
        return error.what();
    }
    return "accepted";
}

/// The radiosities after so many steps of Jacobi's method, with F_ii in the sum but not in the divisor.
double outer_sphere_by_jacobi(int steps) {
    const auto  system = concentric_spheres(2, {0.2, 1}, {0.7, 0});
    Radiosities B      = system.emission;
    for (int k = 0; k < steps; ++k) {
        const Radiosities before = B;
        for (std::size_t i = 0; i < B.size(); ++i)
            B[i] = system.emission[i] + system.reflectance[i] * irradiance(system.form_factors, before, i);
    }
    return B[1].r;
}

}  // namespace

TEST_CASE("a reflectance above 1 has a solution that is no light: it is refused, as is a closed set of 1") {
    CHECK(direct_solution(cube_that_shines(1.1))[0].r == near(-10));  // E / (1 - rho)
    CHECK(after_bounces(1.1, 10) == near((std::pow(1.1, 11) - 1) / 0.1));
    CHECK(after_bounces(1.1, 100) > 1e5);
    CHECK(refusal(cube_that_shines(1.1)).find("1.1") != std::string::npos);

    CHECK(after_bounces(1, 1000) == near(1001));  // and no end
    const std::string closed = refusal(cube_that_shines(1));
    CHECK(closed.find("0, 1, 2, 3, 4, 5") != std::string::npos);

    CHECK(refusal(cube_that_shines(0.999)) == "accepted");
    CHECK(direct_solution(cube_that_shines(0.999))[0].r == near(1000));
}

TEST_CASE(
    "an open scene loses light, and no more than its rows lack: absorbed and lost are what is emitted") {
    const auto box  = solve_patches(cut(polygons_with_aligned_floor(), 250), cornell_box().mesh, 1);
    const auto gone = where_light_goes(box);
    double     sum  = 0;
    for (const double share : gone) {
        CHECK(share >= 0);
        sum += share;
    }
    CHECK(sum == near(1, 1e-4));  // up to the solver's residual
    CHECK(gone.back() > 0.2);
    CHECK(gone.back() < 0.4);
    // rows that are made to add up to 1 would keep what is lost
    CHECK(box.system.form_factors.row_sum(0) < 0.9);
}

TEST_CASE("a face without an area would be 0 / 0 in every row: it is left out, and narrow ones are no harm") {
    CHECK_THROWS_AS(Patch({0, 0, 0}, {1, 0, 0}, {2, 0, 0}), std::invalid_argument);

    Scene scene{.mesh             = {{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {2, 0, 0}}, {{0, 1, 2}, {0, 1, 3}}},
                .materials        = {diffuse_material("paint", {0.5F, 0.5F, 0.5F})},
                .material_of_face = {0, 0}};
    CHECK(polygons_of(scene).size() == 1);

    for (const double width : {1e-4, 1e-8, 1e-12, 1e-14}) {
        CAPTURE(width);
        const double error = sliver_error(width);
        CHECK(error <= 1e-13 / width);  // its normal: rounding of corners 100 from the origin over its width
        CHECK(width * error < 1e-13);   // of light
    }
    CHECK(sliver_error(1e-14) > 1e-3);
    CHECK(std::isnan(sliver_error(1e-16)));
}

TEST_CASE("D3: a hollow sphere that sees itself, and less than half of its light if that is forgotten") {
    CHECK(outer_sphere(0.7, true) == near(0.39772727272727273));
    CHECK(outer_sphere(0.7, false) == near(0.7 / 4 / (1 - 0.2 * 0.7 / 4)));
    CHECK(outer_sphere_by_jacobi(200) == near(0.39772727272727273));
    CHECK(!(std::abs(outer_sphere_by_jacobi(10) / 0.39772727272727273 - 1) < 1e-3));
}

TEST_CASE("a shadow finer than the mesh is not there, whatever the mesh; its mean is") {
    const Visibility visibility(fence());
    const auto       points = points_of_the_floor();
    const auto       exact  = seen_through_fence(points, visibility, 1);
    const auto       coarse = fence_error(10, points, exact, visibility, 1);
    const auto       fine   = fence_error(40, points, exact, visibility, 1);
    CHECK(coarse.constant.value > 0.8);
    CHECK(coarse.interpolated.value > 0.8);
    CHECK(fence_error(1, points, exact, visibility, 1).constant.value / coarse.constant.value ==
          near(1, 0.2));
    CHECK(fine.constant.value < 0.5);
    CHECK(mean_through_fence(10, visibility, 1) / mean_through_fence(40, visibility, 1) == near(1, 0.03));
}
