/// @file radiosity.cpp
/// Chapter 8 from outside: its figures and its claims.

#include <doctest/doctest.h>

#include "chapter_checks.hpp"

using namespace sr::test;

TEST_CASE("chapter 8: claims and text agree, figures have their data, renders do not depend on threads") {
    const ChapterRuns runs("08_radiosity", "--size 64");
    runs.check_claims({});

    for (const auto& row : runs.check_chart("convergence", speed_accuracy_columns, 2 * 6 + 2 * 8 + 5).rows)
        CHECK(row[3].number() > 0);
    runs.check_renders(0);
}
