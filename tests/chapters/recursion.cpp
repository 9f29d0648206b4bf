/// @file recursion.cpp
/// Chapter 7 from outside: its figures and its claims.

#include <doctest/doctest.h>

#include "chapter_checks.hpp"

using namespace sr::test;

TEST_CASE("chapter 7: claims and text agree, figures have their data, renders do not depend on threads") {
    const ChapterRuns runs("07_recursion", "--size 64 --samples 1");
    // Indices of refraction, reflectances, radii, epsilons and a pixel's grey step, given.
    runs.check_claims({6e-5, 1e-4, 3e-4, 0.01, 0.04, 0.25, 0.4, 0.5, 0.75, 0.8, 0.95, 0.99, 1.331, 1.339, 1.5,
                       1e4, 2e4, 1e5});

    runs.check_chart("furnace", {"series", "depth of the rays"}, 100);
    for (const std::string race : {"plates", "quality"})
        for (const auto& row : runs.check_chart(race, speed_accuracy_columns, 20).rows)
            CHECK(row[2].number() > 0);
    runs.check_chart("aberration", {"series"}, 40);
    runs.check_chart("rainbow_angles", {"series"}, 60);
    runs.check_chart("drift", {"series", "bounces"}, 3 * 6);
    runs.check_chart("border", {"series", "distance from the border [rad]"}, 2 * 11);
    runs.check_chart("inside_glass", {"series", "radius of the ball [length units]"}, 2 * 11);
    for (const std::string drawing : {"tree", "water", "prism", "ball_lens", "hollow_mirror", "rainbow"})
        runs.check_chart(drawing, {"shape"}, 20);
    runs.check_renders(15);
}
