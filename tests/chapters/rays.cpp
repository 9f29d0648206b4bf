/// @file rays.cpp
/// Chapter 1 from outside: its figures, its claims, and what it says to bad input.

#include <doctest/doctest.h>

#include <map>

#include "course/csv.hpp"
#include "run_course.hpp"
#include "text_numbers.hpp"

using namespace sr;
using namespace sr::test;

namespace {

Ended run_rays(const fs::path& folder, const std::string& arguments) {
    return run_shell(folder, "'" + (build_folder / "bin" / "01_rays").string() + "' " + arguments);
}

/// Numbers of the text that are no results of the program: what is given, and times, which are charted.
const std::set<double> given{0.035, 0.025, 0.0125, 2.44, 1e-5, 1e-6, 261'632, 16'256, 6e4, 1e5};

std::map<std::string, std::string> renders_in(const fs::path& folder) {
    std::map<std::string, std::string> bytes;
    for (const auto& entry : fs::directory_iterator(folder)) {
        const auto type = entry.path().extension();
        if (type == ".hdr" || type == ".png")
            bytes[entry.path().filename().string()] = read_text(entry.path());
    }
    return bytes;
}

}  // namespace

TEST_CASE("a result in a text is told from an equation's number") {
    const auto sections = sections_of(
        "# 1 T\n\n## 1.2 A\n(1.3), figure 1.4, 16 rays, 0.25 and $3\\cdot10^{-5}$\n"
        "\n## 1.3 B\n61 195, 1e+07 [x](a/9.5)\n");
    REQUIRE(sections.size() == 2);
    CHECK(results_in(sections.at("1.2")) == std::set<double>{0.25, 3e-5});
    CHECK(results_in(sections.at("1.3")) == std::set<double>{61195, 1e7});
}

TEST_CASE(
    "chapter 1: every claim holds, every figure has its data, for any number of threads the same renders") {
    const ScratchFolder scratch{"rays"};
    const Ended         one = run_rays(scratch.path, "--quality draft --size 64 --threads 1 --out one");
    const Ended         all = run_rays(scratch.path, "--quality draft --size 64 --threads 7 --out seven");
    CHECK(one.code == 0);
    CHECK(all.code == 0);
    const fs::path folder = scratch.path / "one" / "01_rays";

    const course::Rows claims = course::read_csv(folder / "claims.csv");
    CHECK(claims.header ==
          std::vector<std::string>{"claim", "expected", "measured", "error", "tolerance", "pass"});
    CHECK(claims.rows.size() >= 20);
    const auto       sections = sections_of(read_text(source_folder / "chapters" / "01_rays" / "README.md"));
    std::set<double> known    = given;
    for (const auto& claim : claims.rows) {
        INFO(claim[0].text());
        CHECK(claim[5].text() == "yes");
        const double expected = claim[1].number();
        known.merge(numbers_of(claim[0].text()));
        known.insert(expected);
        const std::string section = claim[0].text().substr(0, claim[0].text().find(' '));
        REQUIRE(sections.contains(section));
        CHECK((expected == 0 || numbers_of(sections.at(section)).contains(expected)));
    }
    for (const auto& [section, text] : sections) {
        for (const double result : results_in(text)) {
            INFO(section << " says " << result << ", which nothing claims");
            CHECK(known.contains(result));
        }
    }

    for (const auto& [name, rows] : {std::pair{std::string("triangles"), 4 * 8}, {"pixels", 4 * 4}}) {
        const course::Rows chart = course::read_csv(folder / (name + ".csv"));
        CHECK(chart.header == std::vector<std::string>{"method", "effort", "seconds", "error", "error_se",
                                                       "triangles", "pixels", "seconds_min", "seconds_max"});
        CHECK(int(chart.rows.size()) == rows);
        for (const auto& row : chart.rows) {
            CHECK(row[2].number() > 0);
            CHECK(row[3].number() <= 0.02);  // the coarsest teapot's handle has two faces in one place
        }
    }
    for (const std::string name : {"camera", "two_loops", "far_from_the_origin", "triangles", "pixels"}) {
        CHECK(fs::exists(folder / (name + ".csv")));
    }
    CHECK(fs::exists(scratch.path / "one" / "index.html"));

    const auto renders = renders_in(folder);
    CHECK(renders.size() == 12);
    CHECK(renders == renders_in(scratch.path / "seven" / "01_rays"));
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
        const Ended ended = run_rays(scratch.path, "--quality draft --scene " + name);
        CHECK(ended.code == 2);
        CHECK(error_lines(ended) == 1);
        CHECK(ended.err.find(name) != std::string::npos);
        CHECK(read_text(old) == "an older figure");
    }
}

TEST_CASE("chapter 1: a scene of which nothing is seen is rendered, and said to be blank") {
    const ScratchFolder scratch{"rays"};
    std::ofstream(scratch.path / "specks.obj") << "v 0 0 0\nv 1e-6 0 0\nv 0 1e-6 0\nf 1 2 3\n"
                                                  "v 1 1 1\nv 1.000001 1 1\nv 1 1.000001 1\nf 4 5 6\n";
    const Ended ended = run_rays(scratch.path, "--quality draft --size 32 --scene specks.obj");
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
        const Ended ended = run_rays(scratch.path, arguments);
        CHECK(ended.code == 2);
        CHECK(error_lines(ended) == 1);
    }
}
