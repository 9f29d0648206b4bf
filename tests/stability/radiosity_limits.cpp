/// @file radiosity_limits.cpp
/// Where radiosity fails: what goes wrong if nobody looks, beside what is done about it. The scenes are those that
/// chapter 8 charts in section 8.9.

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>
#include <string>
#include <vector>

#include "../../chapters/08_radiosity/aligned_floor.hpp"
#include "../../chapters/08_radiosity/fence.hpp"
#include "../../chapters/08_radiosity/inside_of_a_cube.hpp"
#include "../../chapters/08_radiosity/limit_charts.hpp"
#include "../../chapters/08_radiosity/lost_light.hpp"
#include "../../chapters/08_radiosity/mirror_block.hpp"
#include "../../chapters/08_radiosity/slivers.hpp"
#include "near.hpp"
#include "radiosity/residual.hpp"
#include "radiosity/system_check.hpp"
#include "refusal.hpp"

using namespace sr;
using sr::test::near;

namespace {

std::string refusal(const RadiositySystem& system) {
    return sr::test::refusal_of([&] { check_system(system); });
}

/// Standard error of a balance, in patches of 250 mm: of its rays, and of the rays in the form factors, whose visible
/// shares change it by 0.0027 (standard deviation over six seeds).
double balance_error(const Running& balance) {
    return std::hypot(balance.standard_error(), 0.0027);
}

}  // namespace

TEST_CASE("a reflectance above 1 has a solution that is no light: it is refused, as is a closed set of 1") {
    CHECK(direct_solution(cube_that_shines(1.1))[0].r == near(-10));  // E / (1 - rho)
    CHECK(after_bounces(cube_that_shines(1.1), 10)[0].r == near((std::pow(1.1, 11) - 1) / 0.1));
    CHECK(after_bounces(cube_that_shines(1.1), 100)[0].r > 1e5);
    CHECK(refusal(cube_that_shines(1.1)).find("1.1") != std::string::npos);

    CHECK(after_bounces(cube_that_shines(1), 1000)[0].r == near(1001));  // and no end
    const std::string closed = refusal(cube_that_shines(1));
    CHECK(closed.find("0, 1, 2, 3, 4, 5") != std::string::npos);

    CHECK(refusal(cube_that_shines(0.999)) == "accepted");
    CHECK(direct_solution(cube_that_shines(0.999))[0].r == near(1000));
}

TEST_CASE("a bright closed room is solved to the tolerance, where 1000 steps of Jacobi are not enough") {
    auto faces = inside_of_a_cube();
    for (auto& face : faces) {
        face.reflectance = grey(0.99);
        face.emission    = grey(1);
    }
    const auto patches = cut(faces, 0.5);
    const auto room    = solve_patches(patches, mesh_of(patches).mesh, 1);
    const auto left    = residuals(room.system, room.radiosities, 1);
    CHECK(relative_size(left, room.system.emission) <= 1e-6);
}

TEST_CASE("an open scene loses light, and as much as rays find: absorbed and lost are what is emitted") {
    const auto box  = solve_patches(cut(polygons_with_aligned_floor(), 250), cornell_box().mesh, 1);
    const auto gone = where_light_goes(box, leaving_by_rays(box.patches, 32, 1, 1));
    for (const double share : gone) CHECK(share >= 0);
    CHECK(gone.back() > 0.2);
    CHECK(gone.back() < 0.4);
    const auto sum = balance(box, 1);
    CHECK(sum.mean() == near(1, 4 * balance_error(sum)));
    CHECK(leaving_by_rays(box.patches, 8, 1, 7) == leaving_by_rays(box.patches, 8, 1, 1));
    // rows that are made to add up to 1 would keep what is lost
    CHECK(box.system.form_factors.row_sum(0) < 0.9);
}

TEST_CASE(
    "any reciprocal numbers balance with what their own rows lack; with what rays find, form factors do") {
    auto  box = solve_patches(cut(polygons_with_aligned_floor(), 250), cornell_box().mesh, 1);
    auto& F   = box.system.form_factors;
    Rng   rng{1, 0, 0, 0};
    for (std::size_t i = 0; i < F.size(); ++i)
        for (std::size_t j = 0; j <= i; ++j) {
            const double exchange = rng.uniform<double>() * box.system.area[i] * box.system.area[j];
            F(i, j)               = exchange / box.system.area[i];
            F(j, i)               = exchange / box.system.area[j];
        }
    double largest = 0;
    for (std::size_t i = 0; i < F.size(); ++i) largest = std::max(largest, F.row_sum(i));
    for (std::size_t i = 0; i < F.size(); ++i)
        for (std::size_t j = 0; j < F.size(); ++j) F(i, j) /= largest;
    box.radiosities = direct_solution(box.system);
    std::vector<double> lacking(F.size());
    for (std::size_t i = 0; i < F.size(); ++i) lacking[i] = 1 - F.row_sum(i);
    const auto gone = where_light_goes(box, lacking);
    CHECK(std::accumulate(gone.begin(), gone.end(), 0.0) == near(1, 1e-12));
    const auto sum = balance(box, 1);
    CHECK(std::abs(sum.mean() - 1) > 10 * balance_error(sum));
}

TEST_CASE("a face without an area would be 0 / 0 in every row: it is left out, and narrow ones are no harm") {
    CHECK_THROWS_AS(Patch({0, 0, 0}, {1, 0, 0}, {2, 0, 0}), std::invalid_argument);

    Scene scene{.mesh             = {{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {2, 0, 0}}, {{0, 1, 2}, {0, 1, 3}}},
                .materials        = {diffuse_material("paint", {0.5F, 0.5F, 0.5F})},
                .material_of_face = {0, 0}};
    CHECK(polygons_of(scene).size() == 1);

    for (const double width : {1e-3, 1e-5, 1e-7, 1e-9, 1e-11, 1e-12}) {
        CAPTURE(width);
        const auto errors = sliver_errors(width);
        CHECK(errors.no_area == 0);
        // half a unit in the last place of corners 100 from the origin, over the width: no less, and no more
        CHECK(errors.worst * width == near(100 * std::ldexp(1.0, -53), 0.3));
    }
    CHECK(sliver_errors(1e-16).no_area > 0.8);
}

TEST_CASE("D3: a hollow sphere that sees itself, and less than half of its light if that is forgotten") {
    CHECK(outer_sphere(0.7, true) == near(0.39772727272727273));
    CHECK(outer_sphere(0.7, false) == near(0.7 / 4 / (1 - 0.2 * 0.7 / 4)));
    // F_ii in the sum and not in the divisor comes to the same, and slowly
    const auto spheres = concentric_spheres(2, {0.2, 1}, {0.7, 0});
    CHECK(after_bounces(spheres, 200)[1].r == near(0.39772727272727273));
    CHECK(!(std::abs(after_bounces(spheres, 10)[1].r / 0.39772727272727273 - 1) < 1e-3));
}

TEST_CASE("a mirror painted grey looks wrong; rays that go on at it see what stands before it") {
    const auto      box = box_with_painted_block(250, 1);
    const PatchView view(box.patches);
    const auto      place = [](const SeenPatch& seen) {
        return DoubleSpectrum{seen.position.x, seen.position.y, seen.position.z};
    };
    // On top of the block, y = 165, the eye sees what it would see from below, mirrored: the ceiling, y = 548.8.
    const Vector3<double> eye{20, 480, 10}, top{180, 165, 150};
    const auto            at = view.seen({eye, top - eye});
    REQUIRE(at);
    CHECK(is_short_block(box.patches.polygon[at->patch], box.patches.polygon.back() + 1));
    const auto   seen = with_mirror(box, view, place, eye)(*at);
    const double on   = (548.8 - 165) / (480 - 165);
    CHECK(seen.r == near(0.9 * (180 + on * 160), 1e-6));
    CHECK(seen.g == near(0.9 * 548.8, 1e-6));
    CHECK(seen.b == near(0.9 * (150 + on * 140), 1e-6));
    // What isn't the block is what it was, and what leaves the box is dark.
    const auto wall = view.seen({eye, {1, 0, 0}});
    REQUIRE(wall);
    CHECK(with_mirror(box, view, place, eye)(*wall) == place(*wall));
    const Vector3<double> outside{278, 120, -800}, front{185, 80, 80};
    const auto            facing = view.seen({outside, front - outside});
    REQUIRE(facing);
    CHECK(is_short_block(box.patches.polygon[facing->patch], box.patches.polygon.back() + 1));
    CHECK(with_mirror(box, view, place, outside)(*facing) == DoubleSpectrum{});
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
    // slats as wide as the gaps hide half of the lamp, in the mean
    const Visibility nothing_hides{Mesh<double>{}};
    CHECK(mean_through_fence(10, visibility, 1) / mean_through_fence(10, nothing_hides, 1) ==
          near(0.5, 0.03));
}
