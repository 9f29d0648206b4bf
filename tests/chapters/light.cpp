/// @file light.cpp
/// Chapter 5 from outside: its figures and its claims.

#include <doctest/doctest.h>

#include "chapter_checks.hpp"

using namespace sr::test;

TEST_CASE("chapter 5: claims and text agree, figures have their data, renders do not depend on threads") {
    const ChapterRuns runs("05_light", "--size 64");
    // Given: sizes, sines of half-angles and heights.
    runs.check_claims({0.001, 0.01, 0.1, 1e4, 1e8});

    runs.check_chart("small_areas", {"series"}, 4 * 13);
    runs.check_chart("rounding", {"series"}, 4 * 20);
    for (const std::string measured : {"eclipse", "cosine_law", "setting_lamp"})
        runs.check_chart(measured, {"series"}, 50);
    runs.check_chart("receding", {"series", "distance [radii]"}, 3 * 4);
    runs.check_chart("nested_spheres", {"series", "radius [m]"}, 2 * 4);
    runs.check_chart("skies", {"series", "tilt of the facet [deg]"}, 2 * 31);
    runs.check_chart("near_lamp", {"series", "height of the disk [radii]"}, 2 * 17);
    for (const std::string race : {"disk_lamp", "occluded_lamp"}) {
        for (const auto& row : runs.check_chart(race, speed_accuracy_columns, 6 * 11).rows)
            CHECK(row[2].number() > 0);
    }
    for (const std::string drawing : {"flux_density", "solid_angle", "small_area", "visibility", "radiance",
                                      "orientation", "two_patches", "inverse_square", "sensor"})
        runs.check_chart(drawing, {"shape"}, 15);
    runs.check_renders(3);
}
