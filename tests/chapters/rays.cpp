/// @file rays.cpp
/// Chapter 1 from outside: its figures, its claims, and what it says to bad input.

#include <doctest/doctest.h>

#include <map>

#include "chapter_checks.hpp"

using namespace sr;
using namespace sr::test;

TEST_CASE("a result in a text is told from an equation's number") {
    const auto sections = sections_of(
        "# 1 T\n\n## 1.2 A\n(1.3), figure 1.4, 16 rays, 0.25 and $3\\cdot10^{-5}$\n"
        "\n## 1.3 B\n61 195, 1e+07 [x](a/9.5)\n");
    REQUIRE(sections.size() == 2);
    CHECK(results_in(sections.at("1.2")) == std::set<double>{0.25, 3e-5});
    CHECK(results_in(sections.at("1.3")) == std::set<double>{61195, 1e7});
}

TEST_CASE("chapter 1: claims and text agree, figures have their data, renders do not depend on threads") {
    const ChapterRuns runs("01_rays", "--size 64");
    // What is given, and times, which are charted.
    runs.check_claims({0.035, 0.025, 0.0125, 2.44, 1e-5, 1e-6, 261'632, 16'256, 6e4, 1e5});
    runs.check_renders(6);

    for (const auto& [name, rows] : {std::pair{std::string("triangles"), 4 * 8}, {"pixels", 4 * 4}}) {
        const course::Rows chart = runs.check_chart(name, speed_accuracy_columns, rows);
        for (const auto& row : chart.rows) {
            CHECK(row[2].number() > 0);
            CHECK(row[3].number() <= 0.02);  // the coarsest teapot's handle has two faces in one place
        }
    }
    runs.check_chart("far_from_the_origin", {"series"}, 2 * 8);
    for (const std::string drawing : {"camera", "two_loops"}) runs.check_chart(drawing, {"shape"}, 10);
}

TEST_CASE(
    "chapter 1: a scene that can't be read is one line on stderr, exit code 2, and no figure is touched") {
    const ScratchFolder scratch{"rays"};
    fs::create_directories(scratch.path / "figures" / "01_rays");
    const fs::path old = scratch.path / "figures" / "01_rays" / "scene_depth.png";
    std::ofstream(old) << "an older figure";
    const std::string                        vertices = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
    const std::map<std::string, std::string> scenes{
        {"no_faces.obj", vertices},
        {"index.obj", vertices + "f 1 2 4\n"},
        {"relative.obj", vertices + "f -1 -2 -4\n"},
        {"nan.obj", "v 0 0 nan\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"},
        {"huge.obj", "v 0 0 1e39\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"},
        {"no_mtl.obj", "mtllib missing.mtl\n" + vertices + "f 1 2 3\n"},
        {"empty.obj", ""},
        {"random.obj", std::string("\x7f\x45\x00\xff\x80\x01 v f \x02\n\xfe", 14)},
    };
    for (const auto& [name, text] : scenes) std::ofstream(scratch.path / name, std::ios::binary) << text;
    std::vector<std::string> names{"absent.obj", "figures"};
    for (const auto& [name, text] : scenes) names.push_back(name);
    for (const auto& name : names) {
        INFO(name);
        const Ended ended = run_chapter("01_rays", scratch.path, "--quality draft --scene " + name);
        CHECK(ended.code == 2);
        CHECK(error_lines(ended) == 1);
        CHECK(ended.err.find(name) != std::string::npos);
        CHECK(ended.out.find("1.1") == std::string::npos);  // no section has begun
        CHECK(read_text(old) == "an older figure");
    }
}

TEST_CASE("chapter 1: a scene of which nothing is seen is rendered, and said to be blank") {
    const ScratchFolder scratch{"rays"};
    std::ofstream(scratch.path / "specks.obj") << "v 0 0 0\nv 1e-6 0 0\nv 0 1e-6 0\nf 1 2 3\n"
                                                  "v 1 1 1\nv 1.000001 1 1\nv 1 1.000001 1\nf 4 5 6\n";
    const Ended ended = run_chapter("01_rays", scratch.path, "--quality draft --size 32 --scene specks.obj");
    CHECK(ended.code == 0);
    CHECK(ended.err == "01_rays: scene: no ray hits anything, its pictures are blank\n");
    CHECK(fs::exists(scratch.path / "figures" / "01_rays" / "scene_depth.png"));
}

TEST_CASE("chapter 1: sizes, options and folders that can't be are one line on stderr and exit code 2") {
    const ScratchFolder scratch{"rays"};
    std::ofstream(scratch.path / "file") << "in the way";
    for (const std::string arguments : {"--size 0", "--size 100000", "--size -5", "--size many", "--sise 64",
                                        "--out file", "--out /proc/figures", "--quality best", "--threads 0",
                                        "--samples 0", "--samples 3", "--format gif"}) {
        INFO(arguments);
        const Ended ended = run_chapter("01_rays", scratch.path, arguments);
        CHECK(ended.code == 2);
        CHECK(error_lines(ended) == 1);
    }
}
