/// @file rays_race.cpp
/// What the race of chapter 1 writes down beside its times.

#include <doctest/doctest.h>

#include <map>

#include "course/csv.hpp"
#include "run_course.hpp"

using namespace sr;
using namespace sr::test;

TEST_CASE("chapter 1: an error without a standard error is that of every pixel") {
    const ScratchFolder scratch{"rays"};
    const Ended         ended = run_shell(scratch.path, "'" + (build_folder / "bin" / "01_rays").string() +
                                                            "' --quality draft --size 64 --out there");
    REQUIRE(ended.code == 0);
    const course::Rows chart = course::read_csv(scratch.path / "there" / "01_rays" / "triangles.csv");

    std::map<double, double> in_hierarchy;  // the share of wrong pixels, by the number of triangles
    for (const auto& row : chart.rows)
        if (row[0].text() == "rays, hierarchy") in_hierarchy[row[1].number()] = row[3].number();
    int every_pixel = 0, some_pixels = 0;
    for (const auto& row : chart.rows) {
        if (row[0].text() != "rays, all triangles") continue;
        const bool exact = row[4].number() == 0;
        ++(exact ? every_pixel : some_pixels);
        // Both methods find the same triangles to the bit: of the same pixels, the same share is wrong.
        if (exact) CHECK(row[3].number() == in_hierarchy.at(row[1].number()));
    }
    CHECK(every_pixel >= 1);
    CHECK(some_pixels >= 1);
}
