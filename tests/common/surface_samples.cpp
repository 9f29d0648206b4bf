/// @file surface_samples.cpp
/// Solutions compared at points: a closed room is as bright everywhere, whichever way it is asked.

#include "radiosity/surface_samples.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include "../../chapters/08_radiosity/inside_of_a_cube.hpp"
#include "near.hpp"

using namespace sr;
using sr::test::near;

namespace {

/// The inside of a unit cube, B = E / (1 - rho) = 2 everywhere.
std::vector<Polygon> room() {
    auto faces = inside_of_a_cube();
    for (auto& face : faces) {
        face.reflectance = {0.5, 0.5, 0.5};
        face.emission    = {1, 1, 1};
    }
    return faces;
}

}  // namespace

TEST_CASE("D1: in a closed room each point reflects E rho / (1 - rho), looked up or gathered") {
    const auto       polygons = room();
    const Visibility visibility{mesh_of(cut(polygons, 1)).mesh};
    const auto       samples = surface_samples(polygons, 600, 1);
    for (std::uint32_t i = 0; i < 6; ++i)
        CHECK(std::count_if(samples.begin(), samples.end(),
                            [&](const SurfaceSample& s) { return s.polygon == i; }) == 100);
    const auto solution = hierarchical_radiosity(polygons, visibility, {.bound = 0.02, .tolerance = 1e-7});
    REQUIRE(solution.trees.leaf_count() > 6);
    const Patches     leaves = solution.trees.leaves();
    const Radiosities known(samples.size(), DoubleSpectrum{1, 1, 1});
    const auto        gathered = gathered_at(samples, solution, visibility, 1, {2});
    CHECK(gathered == gathered_at(samples, solution, visibility, 1));
    const auto worst = [&](const Radiosities& values) {
        double most = 0;
        for (const auto& value : values) most = std::max(most, std::abs(value.g - 1));
        return most;
    };
    const auto looked_up = reflected_at(samples, leaves, solution.trees.of_leaves(solution.radiosities));
    CHECK(worst(looked_up) < 0.2);
    CHECK(worst(looked_up) > 0.01);  // the control: leaves get what is not quite right,
    CHECK(worst(gathered) < 0.01);   // and points what is
    CHECK(relative_rms(gathered, known) < relative_rms(looked_up, known) / 5);
}

TEST_CASE("the relative error is that of all primaries") {
    CHECK(relative_rms({{3, 0, 0}, {0, 4, 0}}, {{3, 0, 0}, {0, 0, 4}}) == near(std::sqrt(32.0) / 5, 1e-12));
}

TEST_CASE("a point on another polygon's patch is refused") {
    const auto polygons = room();
    const auto patches  = cut(polygons, 1);
    CHECK_THROWS_AS((void)reflected_at(std::vector<SurfaceSample>{{{0.5, 0.5, 0}, {0, 0, 1}, 3}}, patches,
                                       patches.emission),
                    std::invalid_argument);
}
