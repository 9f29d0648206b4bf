/// @file surfaces.cpp
/// Chapter 2 from outside: its figures and its claims.

#include <doctest/doctest.h>

#include "chapter_checks.hpp"

using namespace sr::test;

TEST_CASE("chapter 2: claims and text agree, figures have their data, renders do not depend on threads") {
    const ChapterRuns runs("02_surfaces", "--size 64");
    // Distances, radii and epsilons that are given.
    runs.check_claims({1e-9, 1e-5, 2e-5, 1e-4, 1e-3, 0.3, 1e4, 1e5, 1e7, 1e9});

    for (const std::string chart : {"sphere_at_a_distance", "sphere_t_error"})
        runs.check_chart(chart, {"series", "distance [radii]"}, 4 * 9);
    runs.check_chart("planet", {"series", "radius of the planet"}, 5 * 7);
    for (const std::string chart : {"leaving_self_hits", "leaving_lost_hits"})
        runs.check_chart(chart, {"series", "radius of the sphere"}, 3 * 11);
    runs.check_chart("steps_that_miss", {"series"}, 10);
    runs.check_chart("normals", {"series"}, 40);
    for (const std::string race : {"methods", "methods_t", "methods_metaballs", "normals_speed"}) {
        for (const auto& row : runs.check_chart(race, speed_accuracy_columns, 6).rows)
            CHECK(row[2].number() > 0);
    }
    for (const std::string drawing : {"along_a_ray", "marching", "sphere_tracing", "intervals"})
        runs.check_chart(drawing, {"shape"}, 20);
    runs.check_renders(5);
}
