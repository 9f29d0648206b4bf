/// @file lit_room.cpp
/// Form factors of a room whose patches' corners are rounded: fifths are no binary fractions.

#include "../../chapters/08_radiosity/lit_room.hpp"

#include <doctest/doctest.h>

#include <cstddef>

#include "near.hpp"

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
