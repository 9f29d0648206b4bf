/// @file hierarchical_radiosity.cpp
/// Hierarchical radiosity: no light is lost between its levels, and it finds what is known of closed rooms.

#include "radiosity/hierarchical_radiosity.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <string>

#include "../../chapters/08_radiosity/inside_of_a_cube.hpp"
#include "near.hpp"
#include "refusal.hpp"
#include "sampling/rng.hpp"
#include "scene/cornell_box.hpp"

using namespace sr;
using sr::test::near;

namespace {

/// The inside of a unit cube with these reflectances and emissions.
std::vector<Polygon> cube(const std::array<double, 6>& reflectance, const std::array<double, 6>& emission) {
    const auto grey  = [](double value) { return DoubleSpectrum{value, value, value}; };
    auto       faces = inside_of_a_cube();
    for (std::size_t i = 0; i < 6; ++i) {
        faces[i].reflectance = grey(reflectance[i]);
        faces[i].emission    = grey(emission[i]);
    }
    return faces;
}

Visibility visibility_of(const std::vector<Polygon>& polygons) {
    return Visibility{mesh_of(cut(polygons, 10)).mesh};
}

HierarchicalSolution solution_of(const std::vector<Polygon>& polygons, const HierarchicalSettings& settings) {
    return hierarchical_radiosity(polygons, visibility_of(polygons), settings);
}

/// The sums of the form factors that each leaf's light arrives by: its own links', and those of all nodes above it.
std::vector<double> row_sums(const HierarchicalSolution& solution) {
    std::vector<double> sums(solution.trees.size()), of_leaves;
    for (const auto& link : solution.links)
        sums[link.receiver] += double(link.form_factor) * double(link.visible);
    for (std::size_t i = 0; i < sums.size(); ++i) {
        const auto& node = solution.trees[i];
        if (node.is_leaf()) of_leaves.push_back(sums[i]);
        for (std::size_t k = 0; k < (node.is_leaf() ? 0 : 4); ++k) sums[node.first_child + k] += sums[i];
    }
    return of_leaves;
}

std::string refusal(const HierarchicalSettings& settings, double reflectance = 0.5) {
    const std::array<double, 6> rho{0.5, 0.5, 0.5, 0.5, 0.5, reflectance};
    return sr::test::refusal_of([&] { (void)solution_of(cube(rho, {1, 0, 0, 0, 0, 0}), settings); });
}

}  // namespace

TEST_CASE("push-pull loses no flux: what all levels gather leaves white polygons") {
    Quadtrees trees(cube({1, 1, 1, 1, 1, 1}, {}));
    Rng       rng{1, 0, 0, 0};
    for (int i = 0; i < 200; ++i)
        (void)trees.children(std::uint32_t(rng.uniform<double>() * double(trees.size())));
    Radiosities gathered(trees.size());
    double      flux = 0, area = 0;
    for (std::size_t i = 0; i < trees.size(); ++i) {
        gathered[i].r = rng.uniform<double>();
        flux += trees[i].shape.area() * gathered[i].r;
    }
    const auto radiosities = trees.push_pull(gathered);
    double     of_polygons = 0, of_leaves = 0;
    for (std::size_t i = 0; i < 6; ++i) of_polygons += trees[i].shape.area() * radiosities[i].r;
    const Patches     leaves = trees.leaves();
    const Radiosities values = trees.of_leaves(radiosities);
    REQUIRE(leaves.size() == trees.leaf_count());
    REQUIRE(values.size() == trees.leaf_count());
    for (std::size_t i = 0; i < leaves.size(); ++i) {
        of_leaves += leaves.shapes[i].area() * values[i].r;
        area += leaves.shapes[i].area();
    }
    CHECK(trees.leaf_count() > 300);
    CHECK(area == near(6, 1e-13));
    CHECK(of_polygons == near(flux, 1e-12));
    CHECK(of_leaves == near(flux, 1e-12));
}

TEST_CASE("D1: in a closed room each leaf's factors add up to 1, within the error that was asked for") {
    double before = 1;
    for (const double bound : {0.02, 0.004, 0.0008}) {
        const auto    solution = solution_of(cube({0.5, 0.5, 0.5, 0.5, 0.5, 0.5}, {1, 1, 1, 1, 1, 1}),
                                             {.bound = bound, .threads = 0});
        const Patches leaves   = solution.trees.leaves();
        const auto    sums     = row_sums(solution);
        REQUIRE(sums.size() == leaves.size());
        double squares = 0;  // of radiosities' errors, rho (sum - 1) B, where B = 2
        for (std::size_t i = 0; i < sums.size(); ++i)
            squares += leaves.shapes[i].area() * (sums[i] - 1) * (sums[i] - 1) / 6;
        CHECK(std::sqrt(squares) < bound * std::sqrt(double(sums.size())));
        CHECK(std::sqrt(squares) < before);
        before = std::sqrt(squares);
        for (std::size_t i = 0; i < 6; ++i) CHECK(solution.radiosities[i].r == near(2, 1e-4));
    }
    CHECK(before > 0.001);  // a test that could not fail would show less
}

TEST_CASE("D5: the area means of the cube with six reflectances, by either oracle") {
    const std::array<double, 6> expected{0.028404191408120217, 0.05599727616715066, 0.082399115260015823,
                                         0.10823833229437256,  0.12786779918237814, 1.0568202470065877};
    const auto                  room  = cube({0.1, 0.2, 0.3, 0.4, 0.5, 0.6}, {0, 0, 0, 0, 0, 1});
    const auto                  error = solution_of(room, {.bound = 1e-4, .threads = 0});
    // Power does not ask how wrong a link is: its error falls slowly, and is still positive on each face.
    const auto power = solution_of(room, {.bound = 1.5e-6, .oracle = LinkOracle::power, .threads = 0});
    for (std::size_t i = 0; i < 6; ++i) {
        CHECK(error.radiosities[i].g == near(expected[i], 1e-3));
        CHECK(power.radiosities[i].g == near(expected[i], 1e-3));
    }
    const auto coarse = solution_of(room, {.bound = 1});
    CHECK(coarse.trees.leaf_count() == 6);
    CHECK(coarse.radiosities[4].g == near(0.13228470375560799, 1e-3));  // D4: one radiosity for a face
}

TEST_CASE("the Cornell box: the same bits for any number of threads, and links grow as leaves do") {
    const Scene      scene    = cornell_box();
    const auto       polygons = polygons_of(scene);
    const Visibility visibility{scene.mesh};
    const auto       one   = hierarchical_radiosity(polygons, visibility, {.bound = 0.01, .threads = 1});
    const auto       seven = hierarchical_radiosity(polygons, visibility, {.bound = 0.01, .threads = 7});
    CHECK(one.radiosities == seven.radiosities);
    CHECK(one.links.size() == seven.links.size());
    const auto fine     = hierarchical_radiosity(polygons, visibility, {.bound = 0.0025, .threads = 0});
    const auto per_leaf = [](const HierarchicalSolution& of) {
        return double(of.links.size()) / double(of.trees.leaf_count());
    };
    CHECK(fine.trees.leaf_count() > 4 * one.trees.leaf_count());
    CHECK(per_leaf(fine) < 2 * per_leaf(one));
    CHECK(fine.bytes() > fine.links.size() * sizeof(RadiosityLink));
}

TEST_CASE("no leaf is below the smallest area") {
    const auto room = cube({0.5, 0.5, 0.5, 0.5, 0.5, 0.5}, {1, 0, 0, 0, 0, 0});
    for (const double smallest : {1.0, 1.0 / 16}) {
        const Patches leaves = solution_of(room, {.bound = 1e-2, .smallest = smallest}).trees.leaves();
        double        least  = 1;
        for (const auto& shape : leaves.shapes) least = std::min(least, shape.area());
        CHECK(least == near(smallest, 1e-12));
    }
}

TEST_CASE("what makes no sense is refused") {
    CHECK(refusal({.bound = 0.1}) == "accepted");
    CHECK(refusal({.bound = 0}) == "hierarchical radiosity: the bound is 0; must be above 0");
    CHECK(refusal({.bound = std::nan("")}) == "hierarchical radiosity: the bound is nan; must be above 0");
    CHECK(refusal({.smallest = -1}) == "hierarchical radiosity: the smallest area is -1; must be 0 or more");
    CHECK(refusal({.tolerance = 0}) == "hierarchical radiosity: the tolerance is 0; must be above 0");
    CHECK(refusal({.strata = 0}) == "hierarchical radiosity: the number of strata is 0; must be 1 or more");
    CHECK(refusal({}, 1.5) == "polygon 5: its reflectance is (1.5, 1.5, 1.5); must be from 0 to 1");
    CHECK(refusal({}, std::nan("")).starts_with("polygon 5: its reflectance is (nan"));
    const std::array<double, 6> white{1, 1, 1, 1, 1, 1};
    const auto                  closed = cube(white, {1, 0, 0, 0, 0, 0});
    CHECK_THROWS_AS((void)solution_of(closed, {.bound = 0.1}), std::runtime_error);
}
