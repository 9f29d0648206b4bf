/// @file boxes.cpp
/// Chapter 4 from outside: its figures and its claims.

#include <doctest/doctest.h>

#include "chapter_checks.hpp"

using namespace sr;
using namespace sr::test;

TEST_CASE("chapter 4: claims and text agree, figures have their data, renders do not depend on threads") {
    const ChapterRuns runs("04_boxes", "--size 64");
    // The example, the lamp, how many rays, the eye, and the teapots.
    runs.check_claims({2.5, 0.5, 0.75, 548.8, 100'000, 0.9, 0.4, 0.3, 16'256, 261'632});
    runs.check_renders(3);

    for (const std::string name : {"hierarchy", "build"}) {
        const course::Rows chart = runs.check_chart(name, speed_accuracy_columns, 3 * 11);
        for (const auto& row : chart.rows) {
            CHECK(row[2].number() > 0);   // seconds
            CHECK(row[3].number() == 0);  // no rung answers unlike brute force
        }
    }
    for (const auto& row : runs.check_chart("rungs", {"method", "triangles", "gain"}, 4 * 13).rows)
        CHECK(row[2].number() > 0);
    for (const auto& row : runs.check_chart("border", {"method", "triangles", "gain"}, 4 * 10).rows)
        CHECK(row[3].number() <= row[4].number());  // quartiles
    // Three curves end where nothing is lost any more.
    runs.check_chart("lost_hits", {"series", "units", "lost_percent", "standard_error"}, 3 * 4 + 13);
    runs.check_chart("chances", {"series", "ratio", "share", "standard_error"}, 2 * 8);
    for (const std::string drawing : {"slabs", "boxes"}) runs.check_chart(drawing, {"shape"}, 20);
}
