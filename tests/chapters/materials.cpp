/// @file materials.cpp
/// Chapter 6 from outside: its figures and its claims.

#include <doctest/doctest.h>

#include "chapter_checks.hpp"

using namespace sr::test;

TEST_CASE("chapter 6: claims and text agree, figures have their data, renders do not depend on threads") {
    const ChapterRuns runs("06_materials", "--size 64 --samples 4");
    // A standard's number and those of (6.5), and indices of refraction.
    runs.check_claims({0.32, 0.45, 15469, 0.2, 1.5});

    runs.check_chart("step_sky", {"series", "angle of view [deg]"}, 4 * 58);
    runs.check_chart("border", {"series", "exponent $e$"}, 4 * 13);
    runs.check_chart("grazing", {"series", "angle of incidence [deg]"}, 6 * 31);
    for (const std::string chart : {"fresnel", "schlick_error", "schlick_inside"})
        runs.check_chart(chart, {"series", "angle of incidence [deg]"}, 70);
    runs.check_chart("radiance_in_glass", {"series"}, 40);
    for (const std::string race : {"albedo_wide", "albedo_narrow"}) {
        for (const auto& row : runs.check_chart(race, speed_accuracy_columns, 3 * 5 + 5).rows)
            CHECK(row[2].number() > 0);
    }
    for (const auto& row : runs.check_chart("albedo_others", speed_accuracy_columns, 2 * 5).rows)
        CHECK(row[2].number() > 0);
    for (const std::string drawing : {"definition", "unclamped", "lobes", "interface"})
        runs.check_chart(drawing, {"shape"}, 15);
    runs.check_renders(6);
}
