/// @file hierarchical_radiosity.cpp
/// Hierarchical radiosity: no light is lost between its levels, and it finds what is known of closed rooms.

#include "radiosity/hierarchical_radiosity.hpp"

#include <doctest/doctest.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <string>

#include "../../chapters/08_radiosity/inside_of_a_cube.hpp"
#include "../../chapters/08_radiosity/slivers.hpp"
#include "../../chapters/08_radiosity/unit_squares.hpp"
#include "near.hpp"
#include "radiosity/visible_share.hpp"
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
    for (const auto& link : solution.links) sums[link.receiver] += double(link.form_factor) * link.visible();
    for (std::size_t i = 0; i < sums.size(); ++i) {
        const auto& node = solution.trees[i];
        if (node.is_leaf()) of_leaves.push_back(sums[i]);
        for (std::size_t k = 0; k < (node.is_leaf() ? 0 : 4); ++k) sums[node.first_child + k] += sums[i];
    }
    return of_leaves;
}

/// A rectangle from (x0, y, 0) to (x1, y, 1) in one grey, its front upwards.
Polygon slab(double x0, double x1, double y, double reflectance, double emission) {
    return {Patch{{x0, y, 0}, {x0, y, 1}, {x1, y, 1}, {x1, y, 0}},
            {reflectance, reflectance, reflectance},
            {emission, emission, emission},
            0};
}

/// What the ceiling, a lamp over the whole length of 2, reflects of light that the floor sends back.
double from_below(const std::vector<Polygon>& floor, double bound) {
    std::vector<Polygon> polygons{slab(0, 2, 1, 0.5, 1)};
    polygons.front().shape = polygons.front().shape.reversed();
    polygons.insert(polygons.end(), floor.begin(), floor.end());
    return solution_of(polygons, {.bound = bound, .strata = 16, .threads = 0}).radiosities[0].r - 1;
}

std::string refusal(const std::vector<Polygon>& polygons, const HierarchicalSettings& settings) {
    return sr::test::refusal_of([&] { (void)solution_of(polygons, settings); });
}

std::string refusal(const HierarchicalSettings& settings, double reflectance = 0.5) {
    return refusal(cube({0.5, 0.5, 0.5, 0.5, 0.5, reflectance}, {1, 0, 0, 0, 0, 0}), settings);
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

TEST_CASE("what quarters of different sizes send counts by their areas") {
    const Patch trapezoid{{0, 0, 0}, {4, 0, 0}, {3, 1, 0}, {0, 1, 0}};
    Quadtrees   trees(std::vector<Polygon>{{trapezoid, {1, 1, 1}, {}, 0}});
    Radiosities gathered(5);
    double      flux = 0;
    for (std::size_t k = trees.children(0), i = 1; i < 5; ++k, ++i) {
        gathered[k].g = double(i);
        flux += trees[k].shape.area() * double(i);
    }
    CHECK(trees[1].shape.area() > 1.05 * trees[4].shape.area());
    CHECK(trees.push_pull(gathered)[0].g == near(flux / trapezoid.area(), 1e-13));
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

TEST_CASE("a floor that is half below a black lid lights the ceiling as its other half alone does") {
    const auto lid = slab(0, 1, 1e-3, 0, 0);
    for (const double bound : {0.1, 0.01}) {  // links from the whole floor, and from its quarters
        const double half = from_below({slab(1, 2, 0, 0.8, 0)}, bound);
        CHECK(half > 0.01);
        CHECK(from_below({slab(0, 2, 0, 0.8, 0), lid}, bound) ==
              near(half, 0.1));  // half of 256 rays or more: a standard error of 3 % at most
    }
}

TEST_CASE("C9: behind a square links find what is left of the light, by either oracle") {
    std::vector<Polygon> polygons;
    for (const Patch& shape :
         {level_square(), level_square(1).reversed(), blocking_square(), blocking_square().reversed()})
        polygons.push_back({shape, {}, {}, 0});
    polygons[0].reflectance = {1, 1, 1};
    polygons[1].emission    = {1, 1, 1};
    for (const auto& [oracle, bound] : {std::pair{LinkOracle::error, 0.002}, {LinkOracle::power, 1e-5}}) {
        const auto solution = solution_of(polygons, {.bound = bound, .oracle = oracle, .threads = 0});
        CHECK(solution.radiosities[0].g == near(behind_a_square, 0.01));
        CHECK(solution.trees.leaf_count() > 100);
    }
}

TEST_CASE("links that no ray passes are not cut as if one did") {
    std::vector<Polygon>       polygons{{level_square(), {1, 1, 1}, {}, 0},
                                  {level_square(1).reversed(), {}, {1, 1, 1}, 0}};
    const HierarchicalSettings settings{.bound  = 0.05,
                                        .oracle = LinkOracle::power};  // of 0.1998 that are sent
    CHECK(solution_of(polygons, settings).trees.leaf_count() > 2);
    polygons.push_back({Patch{{-9, -9, 0.5}, {9, -9, 0.5}, {9, 9, 0.5}, {-9, 9, 0.5}}, {}, {}, 0});
    CHECK(solution_of(polygons, settings).trees.leaf_count() == 3);
}

TEST_CASE("of a patch as narrow as rounding, the quarters' shares are finite and sum to what is seen") {
    const auto slivers_without_a_quarter = [](double width) {
        int without = 0;
        for (int k = 0; k < 50; ++k) {
            const Sliver sliver = any_sliver(k);
            const auto   at     = [&](double s, double t, double z) {
                return sliver.centre + sliver.frame.to_world({s, t, z});
            };
            const Patch          over{at(0, -1, 1), at(0, 1, 1), at(1, 1, 1), at(1, -1, 1)};
            std::optional<Patch> narrow;
            try {
                narrow = Patch{at(0, 0, 0), at(1, 0, 0), at(0, width, 0)};
            } catch (const std::invalid_argument&) {
                continue;  // rounded to a line
            }
            const auto quarters = narrow->quarters();
            without +=
                std::any_of(quarters.begin(), quarters.end(), [](const Patch& q) { return !(q.area() > 0); });
            Rng        rng{1, std::uint32_t(k), 0, 0};
            const auto seen = visible_quarters(over, *narrow, visibility_of({slab(0, 1, -1, 0, 0)}), 4, rng);
            CHECK(seen[0] + seen[1] + seen[2] + seen[3] == near(1, 1e-12));
        }
        return without;
    };
    CHECK(slivers_without_a_quarter(1e-6) == 0);
    CHECK(slivers_without_a_quarter(1e-14) > 0);
}

TEST_CASE("rays know which quarter of a patch they see") {
    const Patch from = slab(0, 1, 1, 0, 0).shape.reversed(), to = slab(0, 1, 0, 0, 0).shape;
    const auto  quarters   = to.quarters();
    const auto  seen_below = [&](const std::vector<Polygon>& between) {
        Rng rng{1, 0, 0, 0};
        return visible_quarters(from, to, visibility_of(between), 32, rng);
    };
    const double noise =
        0.01;  // of 256 rays a quarter, whose weights differ by a third: five standard errors
    const auto all = seen_below({slab(0, 1, -1, 0, 0)});
    CHECK(all[0] + all[1] + all[2] + all[3] == near(1, 1e-12));
    for (const double share : all) CHECK(std::abs(share - 0.25) < noise);
    for (std::size_t hidden = 0; hidden < 4; ++hidden) {
        const auto c     = quarters[hidden].centre();
        auto       lid   = slab(c.x - 0.25, c.x + 0.25, 1e-6, 0, 0);
        const auto p     = lid.shape.corners();
        const auto moved = [&](std::size_t i) {
            return Vector3<double>{p[i].x, p[i].y, c.z + (p[i].z - 0.5) / 2};
        };
        lid.shape       = Patch{moved(0), moved(1), moved(2), moved(3)};
        const auto seen = seen_below({lid});
        for (std::size_t k = 0; k < 4; ++k)
            CHECK(std::abs(seen[k] - (k == hidden ? 0 : 0.25)) < (k == hidden ? 1e-12 : noise));
    }
}

TEST_CASE("the Cornell box: the same bits for any number of threads, and links grow as leaves do") {
    const Scene      scene    = cornell_box();
    const auto       polygons = polygons_of(scene);
    const Visibility visibility{scene.mesh};
    const auto       one   = hierarchical_radiosity(polygons, visibility, {.bound = 0.01, .threads = 1});
    std::atomic<int> told  = 0;
    const auto       seven = hierarchical_radiosity(
              polygons, visibility, {.bound = 0.01, .threads = 7, .on_links = [&](int links) { told += links; }});
    CHECK(told > int(seven.links.size()));  // those, and all that were replaced
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
    for (const int strata : {-2, 0, 3})
        CHECK(refusal({.strata = strata}) ==
              fmt::format("hierarchical radiosity: the number of strata is {}; must be even and above 0",
                          strata));
    CHECK(refusal({}, 1.5) == "polygon 5: its reflectance is (1.5, 1.5, 1.5); must be from 0 to 1");
    CHECK(refusal({}, std::nan("")).starts_with("polygon 5: its reflectance is (nan"));
    for (const auto& [emission, text] : {std::pair{-1.0, "-1"}, {HUGE_VAL, "inf"}, {std::nan(""), "nan"}})
        CHECK(refusal(cube({}, {1, 0, 0, emission, 0, 0}), {}) ==
              fmt::format("polygon 3: its emission is ({0}, {0}, {0}); must be finite, and 0 or more", text));
}

TEST_CASE("a closed set of polygons that reflect all light is named, and what is still to come is known") {
    for (const double tolerance : {1e-4, 2e-3, 0.1})
        CHECK_THROWS_WITH_AS((void)solution_of(cube({1, 1, 1, 1, 1, 1}, {1, 0, 0, 0, 0, 0}),
                                               {.bound = 0.1, .tolerance = tolerance}),
                             doctest::Contains("0.99 and more of it, as 0, 1, 2, 3, 4, 5 do"),
                             std::runtime_error);
    for (const double rho : {0.5, 0.9, 0.99}) {
        const auto room    = cube({rho, rho, rho, rho, rho, rho}, {1, 0, 0, 0, 0, 0});
        const auto rough   = solution_of(room, {.bound = 0.1, .tolerance = 1e-3});
        const auto precise = solution_of(room, {.bound = 0.1, .tolerance = 1e-9});
        for (std::size_t i = 0; i < 6; ++i)
            CHECK(rough.radiosities[i].r == near(precise.radiosities[i].r, 1.1e-3));
    }
}
