/// @file door.cpp
/// The command `course` and its launcher, end to end.

#include <doctest/doctest.h>

#include <initializer_list>
#include <set>

#include "run_course.hpp"

using namespace sr::test;

namespace {

bool contains(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

/// Refused as everything is that a person mistypes: one line on stderr that names it, nothing on stdout, exit code 2.
void check_refused(const std::string& arguments, const std::string& named) {
    CAPTURE(arguments);
    const Ended ended = run_course(arguments);
    CAPTURE(ended.err);
    CHECK(ended.code == 2);
    CHECK(error_lines(ended) == 1);
    CHECK(contains(ended.err, "error: "));
    CHECK(contains(ended.err, named));
    CHECK(ended.out == "");
}

constexpr const char* commands[] = {"figures", "run", "test", "bench", "docs", "list", "doctor"};

/// The launcher where there is neither a compiler nor CMake.
Ended run_bare(const ScratchFolder& scratch, const std::string& shell, const std::string& arguments) {
    return run_shell(scratch.path,
                     "mkdir -p bin; for program in bash sh readlink dirname dpkg-query apt-get; do "
                     "ln -sf \"$(command -v $program)\" bin/ || true; done; "
                     "ln -sf '" +
                         (source_folder / "course").string() +
                         "' link; STERADIAN_NO_INSTALL=1 PATH=$PWD/bin " + shell + " ./link " + arguments);
}

}  // namespace

TEST_CASE("course without a command lists the commands") {
    for (const char* const arguments : {"", "--help", "-h", "help"}) {
        const Ended ended = run_course(arguments);
        CHECK(ended.code == 0);
        CHECK(ended.err == "");
        for (const char* const command : commands) CHECK(contains(ended.out, std::string("\n  ") + command));
    }
}

TEST_CASE("each command has its help") {
    for (const char* const command : commands) {
        const Ended ended = run_course(std::string(command) + " --help");
        CHECK(ended.code == 0);
        CHECK(ended.err == "");
        CHECK(contains(ended.out, std::string("usage: course ") + command));
    }
}

TEST_CASE(
    "each benchmark's help is the comment at its head: what is measured, its columns, and how long that "
    "takes") {
    for (const auto& file : fs::directory_iterator(source_folder / "tests" / "speed")) {
        const Ended ended = run_course("bench " + file.path().stem().string() + " --help");
        CHECK(ended.code == 0);
        CHECK(contains(ended.out, "\n- `"));
        CHECK(contains(ended.out, "It takes "));
        CHECK_FALSE(contains(ended.out, "@file"));
    }
}

TEST_CASE("what is mistyped is refused in one line") {
    check_refused("figure", "figures");
    check_refused("list --sizes", "--sizes");
    check_refused("list 01", "01");
    check_refused("figures --size 0", "--size 0");
    check_refused("figures 77", "77");
    check_refused("run 77", "77");
    check_refused("run", "which");
    check_refused("bench nonsense", "nonsense");
    check_refused("bench --csv x", "topic");
    check_refused("bench rays door", "one topic");
    check_refused("test --foo", "--foo");
    check_refused("figures --out ''", "--out");
}

TEST_CASE("list names the chapters, bench the topics") {
    CHECK(contains(run_course("bench").out, "quality"));
    CHECK(contains(run_course("bench").out, "door"));
    CHECK(contains(run_course("list").out, "01_rays"));
}

TEST_CASE("the doctor finds what this was built with") {
    const Ended ended = run_course("doctor");
    CHECK(ended.code == 0);
    for (const char* const package : {"C++ compiler", "CMake", "GLM", "oneTBB", "doctest", "gnuplot"})
        CHECK(contains(ended.out, package));
}

TEST_CASE("a chapter's bad option passes through: one line, exit code 2") {
    for (const char* const chapter : {"1", "01", "rays", "01_rays"})
        check_refused(std::string("run ") + chapter + " --size 100000", "--size 100000");
    check_refused("run 01 --sise 100", "--size");
    check_refused("run 02 --scene x.obj", "--scene: for the program of a chapter");
    CHECK(contains(run_course("run 01 --help").out, "--quality"));
}

TEST_CASE("the last line of figures names the chapters that failed") {
    const ScratchFolder scratch{"door"};
    const Ended         ended =
        run_course(scratch.path, "figures 01 03 --quality draft --size 32 --samples 7 --out there");
    CHECK(ended.code == 2);
    CHECK(contains(ended.err, "01_rays: error: --samples 7: "));
    CHECK(contains(ended.err, "03_triangles: --samples 7 changes nothing: "));
    CHECK(ended.err.ends_with("course: failed: 01_rays; see above\n"));
    CHECK(fs::exists(scratch.path / "there" / "03_triangles" / "claims.csv"));
}

TEST_CASE("a relative --out means the folder of the person who calls") {
    const ScratchFolder scratch{"door"};
    const Ended         ended =
        run_course(scratch.path, "figures 01 --quality draft --size 32 --samples 1 --out there");
    CAPTURE(ended.err);
    CHECK(ended.code == 0);
    CHECK(fs::exists(scratch.path / "there" / "01_rays" / "claims.csv"));
    CHECK(fs::exists(scratch.path / "there" / "index.html"));
}

TEST_CASE("the site is made without a warning, and its first page named") {
    const std::string packages = read_text(build_folder / "packages.csv");
    if (contains(packages, "Doxygen,docs,missing") || contains(packages, "MathJax,docs,missing")) return;
    const Ended ended = run_course("docs");
    CAPTURE(ended.err);
    CHECK(ended.code == 0);
    CHECK(ended.err == "");
    const fs::path page = build_folder / "docs" / "html" / "index.html";
    CHECK(ended.out == page.string() + "\n");
    CHECK(contains(read_text(page), "Steradian"));
}

TEST_CASE("test and bench hand on what a person names") {
    const ScratchFolder scratch{"door"};
    const auto told = [&](const std::string& arguments) {  // in place of ctest and CMake, which take long
        return run_shell(scratch.path,
                         "for name in ctest cmake; do printf '#!/bin/sh\necho %s \"$@\"\n' $name >"
                         "$name; chmod +x $name; done; PATH=$PWD:$PATH '" +
                             (build_folder / "bin" / "course").string() + "' " + arguments);
    };
    const Ended test = told("test shapes 'a b'");
    CHECK(test.code == 0);
    CHECK(contains(test.err, "cmake --build " + build_folder.string() + "\n"));
    CHECK(test.out.starts_with("ctest --test-dir " + build_folder.string() + " "));
    CHECK(test.out.ends_with(" --tests-regex shapes|a b\n"));
    CHECK_FALSE(contains(told("test").out, "--tests-regex"));

    const std::string topic = (source_folder / "tests" / "speed" / "door.cmake").string();
    CHECK(told("bench door --csv x.csv").out ==
          "cmake -DCSV=" + (scratch.path / "x.csv").string() + " -P " + topic + "\n");
    CHECK(told("bench door").out == "cmake -P " + topic + "\n");
}

TEST_CASE("a long build is announced where its steps are not shown") {
    const ScratchFolder scratch{"door"};
    const auto          told = [&](const std::string& steps) {  // by a build of so many
        return run_shell(scratch.path, "printf '#!/bin/sh\necho \"[1/" + steps +
                                                    "] Building\"\n' >cmake; chmod +x cmake; PATH=$PWD:$PATH '" +
                                                    (build_folder / "bin" / "course").string() + "' docs")
            .err;
    };
    CHECK(told("10") == "course: building, this takes a minute or more\n");
    CHECK(told("9") == "");
}

TEST_CASE("Ctrl-C ends a chapter with 130 and leaves no part of a file") {
    const ScratchFolder scratch{"door"};
    const std::string   course  = (build_folder / "bin" / "course").string();
    const fs::path      started = scratch.path / "there" / "01_rays";
    Ended               ended;
    for (int seconds = 1; seconds <= 32 && !fs::exists(started); seconds *= 2)  // a busy machine starts late
        ended = run_shell(scratch.path, "timeout --preserve-status -s INT " + std::to_string(seconds) + " '" +
                                            course + "' run 01 --quality print --out there");
    CAPTURE(ended.err);
    REQUIRE(fs::exists(started));
    CHECK(ended.code == 130);
    CHECK(contains(ended.err, "01_rays: interrupted: "));
    CHECK(contains(ended.err, " so far in there/01_rays\n"));
    for (const auto& entry : fs::recursive_directory_iterator(scratch.path))
        CHECK_FALSE(entry.path().filename().string().starts_with('.'));
}

TEST_CASE("where no compiler is, the launcher helps, lists, and tells in one command how to get one") {
    const ScratchFolder scratch{"door"};
    for (const char* const arguments : {"", "--help", "-h", "help", "list"}) {
        const Ended bare = run_bare(scratch, "bash", arguments), built = run_course(scratch.path, arguments);
        CHECK(bare.code == 0);
        CHECK(bare.err == "");
        CHECK(bare.out == built.out);
    }
    CHECK(contains(run_bare(scratch, "bash", "help").out, "STERADIAN_NO_INSTALL"));

    const Ended doctor = run_bare(scratch, "bash", "doctor");
    CHECK(doctor.code == 1);
    CHECK(contains(doctor.out, "missing: C++ compiler, CMake, Ninja, "));
    CHECK(contains(doctor.out, "apt-get update && "));
    CHECK(contains(doctor.out, " cmake ninja-build "));

    const Ended refused = run_bare(scratch, "bash", "run 01");
    CHECK(refused.code == 2);
    CHECK(error_lines(refused) == 1);
    CHECK(contains(refused.err, "missing: C++ compiler, CMake, Ninja; install "));
    CHECK(contains(refused.err, "apt-get update && "));
}

TEST_CASE("the launcher in another shell says that it is for bash") {
    const ScratchFolder scratch{"door"};
    const Ended         ended = run_bare(scratch, "sh", "list");
    if (contains(run_shell(scratch.path, "sh -c 'echo $BASH_VERSION'").out, ".")) return;  // sh is bash here
    CHECK(ended.code == 2);
    CHECK(error_lines(ended) == 1);
    CHECK(contains(ended.err, "bash"));
}

TEST_CASE("vcpkg.json names the packages of packages.csv") {
    std::ifstream     rows(source_folder / "common" / "packages.csv");
    const std::string vcpkg = read_text(source_folder / "vcpkg.json");
    int               count = 0;
    for (std::string row; std::getline(rows, row);) {
        std::string name = row.substr(row.rfind(',') + 1);
        name             = name.substr(0, name.find('['));
        if (name == "-" || name == "vcpkg") continue;
        CAPTURE(name);
        CHECK(contains(vcpkg, '"' + name + '"'));
        ++count;
    }
    CHECK(count == 9);
}
