/// @file monte_carlo.cpp
/// Chapter 9 from outside: its figures and its claims.

#include <doctest/doctest.h>

#include "chapter_checks.hpp"

using namespace sr::test;

TEST_CASE("chapter 9: claims and text agree, figures have their data, renders do not depend on threads") {
    const ChapterRuns runs("09_monte_carlo", "--size 64");
    runs.check_claims({});
}
