/// @file radiosity_system_check.cpp
/// Systems that are no light, or that have no solution, are refused, and what is wrong with them is named.

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "../../chapters/08_radiosity/known_systems.hpp"
#include "radiosity/direct_solution.hpp"
#include "radiosity/system_check.hpp"
#include "refusal.hpp"

using namespace sr;

namespace {

using Sets = std::vector<std::vector<std::size_t>>;

std::string refusal(const RadiositySystem& system, double tolerance = 1e-6) {
    return sr::test::refusal_of([&] { check_system(system, tolerance); });
}

const RadiositySystem good = two_plates({0.5, 1}, {0.5, 0});

/// Two pairs of plates that don't see each other, of which a share of the light of the second pair is lost.
RadiositySystem two_rooms(double first, double second, double kept = 1) {
    return grey_system({{first, 0}, {second, 0}, {first, 0}, {second, 0}}, [=](std::size_t i, std::size_t j) {
        if (i % 2 != j % 2 || i == j) return 0.0;
        return i % 2 == 0 ? 1 : kept;
    });
}

}  // namespace

TEST_CASE("a good system is accepted, up to reflectances of 1 that lose light elsewhere") {
    CHECK(refusal(good) == "accepted");
    CHECK(refusal(two_plates({1, 1}, {0.999, 0})) == "accepted");
    CHECK(refusal(corner_of_strips({1, 1}, {1, 0})) == "accepted");
}

TEST_CASE("sizes, reflectances, emissions, areas and form factors are checked, each with its patch") {
    auto sizes = good;
    sizes.area.push_back(1);
    CHECK(refusal(sizes) == "the system has 2 rows of form factors for 3 areas; there must be as many");
    sizes = good;
    sizes.reflectance.pop_back();
    CHECK(refusal(sizes) == "the system has 1 reflectances for 2 areas; there must be as many");
    sizes = good;
    sizes.emission.pop_back();
    CHECK(refusal(sizes) == "the system has 1 emissions for 2 areas; there must be as many");
    CHECK(refusal({FormFactorMatrix(0), {}, {}, {}}) == "the system has no patches; must be at least one");

    const auto with = [](const auto& change) {
        auto system = good;
        change(system);
        return refusal(system);
    };
    CHECK(with([](auto& s) { s.reflectance[1].g = 1.25; }) ==
          "the reflectance of patch 1 is (0.5, 1.25, 0.5); must be 0 to 1");
    CHECK(with([](auto& s) { s.reflectance[0].r = std::nextafter(1, 2); }) ==
          "the reflectance of patch 0 is (1.0000000000000002, 0.5, 0.5); must be 0 to 1");
    CHECK(with([](auto& s) { s.reflectance[0].b = -0.5; }) ==
          "the reflectance of patch 0 is (0.5, 0.5, -0.5); must be 0 to 1");
    CHECK(with([](auto& s) { s.reflectance[1].b = std::nan(""); }) ==
          "the reflectance of patch 1 is (0.5, 0.5, nan); must be 0 to 1");
    CHECK(with([](auto& s) { s.emission[0].r = -1; }) ==
          "the emission of patch 0 is (-1, 1, 1); must be 0 or more, and finite");
    CHECK(with([](auto& s) { s.emission[0].r = HUGE_VAL; }) ==
          "the emission of patch 0 is (inf, 1, 1); must be 0 or more, and finite");
    CHECK(with([](auto& s) { s.area[1] = 0; }) == "the area of patch 1 is 0; must be above 0, and finite");
    CHECK(with([](auto& s) { s.area[0] = HUGE_VAL; }) ==
          "the area of patch 0 is inf; must be above 0, and finite");
    CHECK(with([](auto& s) { s.area[0] = std::nan(""); }) ==
          "the area of patch 0 is nan; must be above 0, and finite");
    CHECK(with([](auto& s) { s.form_factors(1, 0) = HUGE_VAL; }) ==
          "the form factor from patch 1 to patch 0 is inf; must be 0 to 1");
    CHECK(with([](auto& s) { s.form_factors(0, 1) = -0.5; }) ==
          "the form factor from patch 0 to patch 1 is -0.5; must be 0 to 1");
    CHECK(with([](auto& s) { s.form_factors(1, 1) = std::nan(""); }) ==
          "the form factor from patch 1 to patch 1 is nan; must be 0 to 1");
    CHECK(with([](auto& s) { s.form_factors(1, 1) = 0.25; }) ==
          "the form factors from patch 1 sum to 1.25; must be 1 at most (within 1e-06), or light is made of "
          "nothing");
}

TEST_CASE("a row may sum to more than 1 by what its factors are known to be wrong by") {
    auto system               = good;
    system.form_factors(0, 1) = 1.005;
    CHECK(refusal(system, 0.01) == "accepted");
    CHECK(refusal(system, 0.001) != "accepted");
    CHECK(refusal(system, std::nan("")) != "accepted");
}

TEST_CASE("but not by so much that the patch sends on more than there is: the solution would be negative") {
    // Five faces of a cube that reflect all and get 1.008 of it, and one that absorbs 0.02: a bounce makes 1.0047 of 1.
    auto cube = cube_of_faces({{1, 1}, {1, 1}, {1, 1}, {1, 1}, {1, 1}, {0.98, 1}});
    CHECK(refusal(cube, 0.01) == "accepted");
    for (std::size_t i = 0; i < 6; ++i)
        for (auto& factor : cube.form_factors.row(i)) factor *= 1.008;
    CHECK(direct_solution(cube)[0].r < 0);
    CHECK(refusal(cube, 0.01) ==
          "light gets no less in 1000 bounces, since form factors sum to more than 1: those of patch 0 to "
          "1.008, "
          "and it reflects 1; must reflect less");
    // in any of the primaries: light that goes there and back is multiplied by 1.25, 0.9 and the reflectance
    for (const auto primary : {&DoubleSpectrum::r, &DoubleSpectrum::g, &DoubleSpectrum::b}) {
        auto coloured                    = good;
        coloured.form_factors(0, 1)      = 1.25;
        coloured.reflectance[1].*primary = 0.9;
        coloured.reflectance[0].*primary = 0.89;
        CHECK(refusal(coloured, 0.3).starts_with("light gets no less in 1000 bounces"));
        coloured.reflectance[0].*primary = 0.88;
        CHECK(refusal(coloured, 0.3) == "accepted");
    }
}

TEST_CASE("the patch that sends on more than it gets is named, wherever it is") {
    auto plates               = two_plates({0.9, 1}, {0.89, 1});
    plates.form_factors(1, 0) = 1.25;
    CHECK(refusal(plates, 0.3) ==
          "light gets no less in 1000 bounces, since form factors sum to more than 1: those of patch 1 to "
          "1.25, and it reflects 0.89; must reflect less");
}

TEST_CASE(
    "light that gets more on its way is followed to where it is lost, in as many bounces as that takes") {
    // Each patch sees the next one, and the last one is black: the first one's light is there after nine bounces.
    constexpr std::size_t  n = 10;
    std::vector<GreyPatch> white(n, {1, 1});
    white.back().reflectance = 0;
    const auto chain =
        grey_system(white, [](std::size_t i, std::size_t j) { return j == i + 1 ? 1.005 : 0; });
    CHECK(refusal(chain, 0.01) == "accepted");
}

TEST_CASE("computed rows may exceed 1 where a white patch sees dark ones") {
    auto cube = cube_of_faces({{0.5, 1}, {1, 0}, {0.5, 0}, {0.5, 0}, {0.5, 0}, {0.5, 0}});
    for (auto& factor : cube.form_factors.row(1)) factor *= 1 + 3e-8;
    CHECK(cube.form_factors.row_sum(1) > 1);
    CHECK(refusal(cube) == "accepted");
    for (auto& rho : cube.reflectance) rho = {1, 1, 1};
    CHECK(refusal(cube).starts_with("patches 0, 1, 2, 3, 4, 5 reflect all light"));
}

TEST_CASE("patches that keep all light to themselves are named") {
    CHECK(refusal(two_plates({1, 1}, {1, 0})) ==
          "patches 0, 1 reflect all light, and only to each other: it never gets less, and there is no "
          "solution; one "
          "of them must have a reflectance below 1");
    CHECK(perfect_enclosures(two_rooms(1, 1)) == Sets{{0, 2}, {1, 3}});
    CHECK(perfect_enclosures(two_rooms(0.5, 1)) == Sets{{1, 3}});
    CHECK(perfect_enclosures(two_rooms(1, 1, 0.99)) == Sets{{0, 2}});
    CHECK(perfect_enclosures(two_rooms(0.5, 0.5)).empty());

    for (const auto primary : {&DoubleSpectrum::r, &DoubleSpectrum::g, &DoubleSpectrum::b}) {
        auto coloured = good;
        for (auto& reflectance : coloured.reflectance) reflectance.*primary = 1;
        CHECK(perfect_enclosures(coloured) == Sets{{0, 1}});
    }

    const auto large = inside_of_a_sphere(std::vector<GreyPatch>(20, {1, 1}));
    CHECK(refusal(large).find("patches 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11 and 8 more reflect") == 0);
}

TEST_CASE("one perfect patch that sees the way out lets no set be perfect") {
    // A chain: 0 and 1 see each other, 1 also sees 2, which absorbs a little.
    const auto chain = grey_system({{1, 1}, {1, 0}, {0.999, 0}}, [](std::size_t i, std::size_t j) {
        if (i == 1) return j == 1 ? 0.0 : 0.5;
        return j == 1 ? 1.0 : 0.0;
    });
    CHECK(perfect_enclosures(chain).empty());
}

TEST_CASE("rows that make as much light as the patch takes are perfect as well") {
    const auto gains = grey_system({{0.999, 1}, {0.999, 1}},
                                   [](std::size_t i, std::size_t j) { return i == j ? 0 : 1.005; });
    CHECK(perfect_enclosures(gains, 0.01) == Sets{{0, 1}});
}

TEST_CASE("a perfect enclosure is all that its light goes to and comes from, in order") {
    const auto sets = [](const auto& factor) {
        return perfect_enclosures(grey_system(std::vector<GreyPatch>(3, {1, 1}), factor));
    };
    const auto to = [](std::size_t a, std::size_t b, std::size_t c) {  // each sees one
        return [=](std::size_t i, std::size_t j) { return j == std::array{a, b, c}[i] ? 1 : 0; };
    };
    CHECK(sets(to(1, 2, 2)) == Sets{{0, 1, 2}});   // all of it ends in a hollow, the last one, and
    CHECK(sets(to(0, 0, 1)) == Sets{{0, 1, 2}});   // the first one
    CHECK(sets([](std::size_t i, std::size_t j) {  // two that see each other by the third alone
              if (i == 2) return j == 2 ? 0.0 : 0.5;
              return j == 2 ? 1.0 : 0.0;
          }) == Sets{{0, 1, 2}});
}
