/// @file lit_room.cpp
/// Form factors of a room whose patches' corners are rounded: fifths are no binary fractions.

#include "../../chapters/08_radiosity/lit_room.hpp"
#include "../../chapters/08_radiosity/lit_part.hpp"

#include <doctest/doctest.h>

#include <cstddef>

#include "near.hpp"
#include "radiosity/gauss_seidel.hpp"

using namespace sr;
using sr::test::near;

TEST_CASE("the pieces of one wall exchange nothing, however their corners are rounded") {
    constexpr std::size_t n = 5, face = n * n;
    const auto            room = lit_room(n, 0.5, 0);
    REQUIRE(room.size() == 6 * face);
    for (std::size_t i = 0; i < room.size(); ++i) {
        for (std::size_t j = i / face * face; j < (i / face + 1) * face; ++j)
            CHECK(room.form_factors(i, j) == 0);
        CHECK(room.form_factors.row_sum(i) == near(1, 1e-3));  // the settings' tolerance
    }
}

TEST_CASE("the middle of the room's ceiling shines") {
    const auto room   = lit_room(4, 0.5, 0);
    double     shines = 0;
    for (std::size_t i = 0; i < room.size(); ++i) shines += room.area[i] * room.emission[i].r;
    CHECK(shines == near(0.25, 1e-12));
}

TEST_CASE("the lit part of a closed room is its inside, black walls included, and lamps wherever they are") {
    auto       polygons = inside_of_a_cube();
    const auto inside   = polygons;
    for (auto polygon : inside) {
        polygon.shape = polygon.shape.reversed();
        polygons.push_back(polygon);
    }
    for (auto& polygon : polygons) polygon.reflectance = grey(0.5);
    polygons[0].reflectance = {};
    polygons[1].emission    = grey(1);
    polygons[9].emission    = grey(1);  // outside, where nothing sees it
    const Patches patches   = cut(polygons, 1);
    const auto    system    = system_of(patches, form_factors(patches, Visibility(mesh_of(patches).mesh)));
    const Patches lit       = lit_part(patches, system, solution_by(GaussSeidel(system), 1e-9, 100));
    REQUIRE(lit.size() == 7);
    for (std::size_t i = 0; i < 6; ++i) CHECK(lit.polygon[i] == i);
    CHECK(lit.polygon[6] == 9);
    CHECK(lit.corners[6] == patches.corners[9]);
    CHECK(lit.reflectance[0] == DoubleSpectrum{});
    CHECK(lit.emission[6] == grey(1));
}
