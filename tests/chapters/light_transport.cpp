/// @file light_transport.cpp
/// Chapter 10 from outside: its figures and its claims.

#include <doctest/doctest.h>

#include "chapter_checks.hpp"

using namespace sr::test;

TEST_CASE("chapter 10: claims and text agree, figures have their data, renders do not depend on threads") {
    const ChapterRuns runs("10_light_transport", "--size 32");
    // Given: numbers of paths, and an index of refraction.
    runs.check_claims({20'000, 30'000, 1.5});

    for (const auto& row : runs.check_chart("random_path_errors", {"series"}, 2 * 3).rows)
        CHECK(row[2].number() > 0);
    runs.check_chart("near_lamp", {"series"}, 2 * 31 + 9 + 13);
    runs.check_chart("plate_errors", {"shape"}, 3 * 4 * 4 * 5);
    runs.check_chart("roulette_variance", {"series"}, 2 * 60 + 2 * 10);
    runs.check_chart("roulette_cost", {"series"}, 4 * 100 + 4 * 6);
    runs.check_chart("infinite_variance", {"series"}, 5 * 600);
    for (const auto& row : runs.check_chart("path_ends", speed_accuracy_columns, 7 * 2).rows) {
        CHECK(row[2].number() > 0);
        CHECK(row[3].number() > 0);
    }
    runs.check_chart("partial_sums", {"series"}, 3 * 10 + 9 * 10);
    runs.check_chart("scores", {"series"}, 71 + 2 * 14);
    runs.check_chart("shining_ball", {"series"}, 2 * (25 + 13));
    runs.check_chart("bleeding", {"series"}, 3 * (5 + 5));
    runs.check_chart("ball_on_floor", {"series"}, 80 + 16);
    runs.check_chart("lamp_in_ball", {"series"}, 2 * 61 + 16);
    runs.check_chart("mistakes", {"shape"}, 12 + 8 * (1 + 6 * 7));
    runs.check_chart("box_shadow", {"series"}, 3 * 110);
    runs.check_chart("responses", {"series"}, 3 * 81 + 3 * 21);
    for (const auto& row : runs.check_chart("strategies", speed_accuracy_columns, 8 * 2 + 2).rows)
        for (const int positive : {2, 3, 4}) CHECK(row[std::size_t(positive)].number() > 0);
    runs.check_chart("efficiency", {"series"}, 8 * 2);
    runs.check_chart("deviations", {"series"}, 48 + 2 * 120);
}
