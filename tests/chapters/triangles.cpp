/// @file triangles.cpp
/// Chapter 3 from outside: its claims, its text and its figures.

#include <doctest/doctest.h>

#include "chapter_checks.hpp"

using namespace sr;
using namespace sr::test;

TEST_CASE("chapter 3: claims and text agree, figures have their data, renders do not depend on threads") {
    const ChapterRuns runs("03_triangles", "--size 64");
    // What is given: rays of an attack, the vectors of a cross product, Kahan's 1.5 units.
    runs.check_claims({40'000, 1.0001, 0.9999, 1.5});
    runs.check_renders(3);

    const auto leaks  = runs.check_chart("leaks", speed_accuracy_columns, 4 * 2);
    const auto method = leaks.column("method"), least = leaks.column("least"), most = leaks.column("most"),
               t_error = leaks.column("t_error");
    for (const auto& row : leaks.rows) {
        CHECK(row[2].number() > 0);
        if (row[method].text() == "watertight" || row[method].text() == "as published")
            CHECK(row[most].number() == 0);
        else
            CHECK(row[least].number() > 5);
        CHECK(row[t_error].number() <= 1e-7);
    }
    for (const std::string name : {"small_triangles", "needles", "far_away"})
        runs.check_chart(name, {"series"}, 30);
    for (const std::string drawing : {"weights", "slit"}) runs.check_chart(drawing, {"shape"}, 10);
}
