/// @file radiosity.cpp
/// Chapter 8 from outside: its figures and its claims.

#include <doctest/doctest.h>

#include "chapter_checks.hpp"

using namespace sr::test;

TEST_CASE("chapter 8: claims and text agree, figures have their data, renders do not depend on threads") {
    const ChapterRuns runs("08_radiosity", "--size 64");
    runs.check_claims({});

    for (const std::string pair : {"form_factors", "form_factors_opposed", "form_factors_touching",
                                   "form_factors_distant", "form_factors_occluded"}) {
        for (const auto& row : runs.check_chart(pair, speed_accuracy_columns, 33).rows)
            CHECK(row[3].number() > 0);
    }
    const auto all = runs.check_chart(
        "form_factors", {"method", "effort", "seconds", "error", "error_se", "pair"}, 3 * 40 + 33);
    std::set<std::string> pairs_with_methods;
    for (const auto& row : all.rows) pairs_with_methods.insert(row[5].text() + ": " + row[0].text());
    CHECK(pairs_with_methods.size() == 3 * 7 + 6);
    runs.check_chart("touching", {"series", "pieces along a side of each square"}, 3 * 6);
    runs.check_chart("near_patches", {"series", "distance [sides]"}, 3 * 31);
    runs.check_chart("closure", {"series"}, 3 * 31);
    for (const std::string drawing : {"form_factor", "nusselt", "hemicube"})
        runs.check_chart(drawing, {"shape"}, 15);
    runs.check_chart("bounces", {"series"}, 4 * 10);
    runs.check_chart("lambda", {"series"}, 3 * (18 + 179));
    runs.check_chart("lambda_map", {"series"}, 2 * 100);
    for (const std::string room : {"solvers", "solvers_dark", "solvers_bright"}) {
        for (const auto& row : runs.check_chart(room, speed_accuracy_columns, 1 + 5 * 5).rows)
            CHECK(row[3].number() > 0);
    }
    for (const std::string room : {"residuals", "residuals_dark", "residuals_middling"})
        runs.check_chart(room, {"series"}, 4 * 12 + 2 * 12);
    for (const std::string room : {"residuals_in_time", "residuals_in_time_dark", "residuals_in_time_bright"})
        runs.check_chart(room, {"series", "time on one core [s]"}, 3 * 2 * 5);
    runs.check_chart("ambient", {"series"}, 2 * 30);
    runs.check_chart("towards_one", {"series"}, 5 * 16);
    runs.check_chart("stagnation", {"series"}, 2 * 19 + 15);
    runs.check_chart("surfaces", {"shape"}, 15);
    for (const auto& row : runs.check_chart("convergence", speed_accuracy_columns, 2 * 6 + 2 * 8 + 5).rows)
        CHECK(row[3].number() > 0);
    runs.check_chart("corners", {"series", "patches"}, 4 * 7);
    runs.check_chart("leaks", {"series", "$x$ [mm]"}, 4 * 92);
    runs.check_chart("parts", {"shape"}, 8 * 9);
    runs.check_chart("links", {"shape"}, 100);
    for (const std::string chart : {"scaling", "error_against_time"}) {
        for (const auto& row :
             runs.check_chart(chart, {"method", "n", "seconds", "mebibytes", "error"}, 2 * 3).rows)
            CHECK(row[2].number() > 0);
    }
    runs.check_chart("above_one", {"series", "reflectance"}, 46 + 31);
    runs.check_chart("closed_set", {"series", "bounces added up"}, 4 * 13);
    runs.check_chart("lost_light", {"shape"}, 9);
    runs.check_chart("slivers", {"series", "width", "relative error, or share"}, 3 * 24 + 21);
    runs.check_chart("sees_itself", {"series"}, 2 * 39);
    runs.check_chart("fence", {"series"}, 2 * 12);
    runs.check_renders(19);
}
