/// @file monte_carlo.cpp
/// Chapter 9 from outside: its figures and its claims.

#include <doctest/doctest.h>

#include "chapter_checks.hpp"

using namespace sr::test;

TEST_CASE("chapter 9: claims and text agree, figures have their data, renders do not depend on threads") {
    const ChapterRuns runs("09_monte_carlo", "--size 64");
    // Given: a height from which on there are dots, and what is added to a seed.
    runs.check_claims({0.1, 12345});

    for (const std::string drawing : {"sample_sizes", "directions", "inversion"})
        runs.check_chart(drawing, {"shape"}, 30);
    runs.check_chart("running_means", {"series"}, 7 * 49);
    runs.check_chart("power_variance", {"series"}, 2 * 33 + 2 * 7);
    runs.check_chart("cap_light", {"series"}, 3 * 65 + 3 * 8);
    runs.check_chart("rejection", {"series"}, 2 * 201 + 280);
    runs.check_chart("trials", {"series"}, 19 + 11);
    runs.check_chart("clipped", {"series"}, 2 * 201 + 40);
    runs.check_chart("rejection_time", {"series"}, 3 * 7);
    runs.check_chart("what_counts", {"series"}, 3 * 101 + 81);
    runs.check_chart("exponents", {"series"}, 108 + 11);
    runs.check_chart("overhead_lamp", {"series"}, 3 * 31 + 3 * 13);
    for (const auto& row : runs.check_chart("densities", speed_accuracy_columns, 5 * 5).rows)
        CHECK(row[3].number() > 0);
    runs.check_chart("stopping", {"series"}, 3 * 22 + 3 * 5);
    runs.check_chart("stopping_error", {"series"}, 3 * 22);
    runs.check_chart("jumps", {"series"}, 4 * 900);
    runs.check_chart("heavy_tails", {"series"}, 5 * 6);
    runs.check_chart("sums", {"series"}, 2 * 64);
    for (const std::string drawing : {"patterns", "net", "scrambling"})
        runs.check_chart(drawing, {"shape"}, 60);
    for (const std::string chart :
         {"convergence", "convergence_edge", "convergence_time", "convergence_time_edge"})
        for (const auto& row : runs.check_chart(chart, speed_accuracy_columns, 3 * 11 + 6).rows) {
            const bool is_law = row[0].text().starts_with('$');  // drawn beside what is measured
            CHECK(row[3].number() > 0);
            CHECK((is_law || row[2].number() > 0));
            CHECK((is_law || row[4].number() > 0));
        }
    runs.check_chart("dimensions_smooth", {"series", "dimensions"}, 4 * 11 + 7);
    runs.check_chart("dimensions_ball", {"series", "dimensions"}, 5 * 8);
    runs.check_renders(9);
}
