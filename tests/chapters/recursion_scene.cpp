/// @file recursion_scene.cpp
/// Chapter 7 on scenes that a person brings along.

#include <doctest/doctest.h>

#include <fstream>
#include <set>
#include <string>
#include <utility>

#include "chapter_checks.hpp"

using namespace sr::test;

namespace {

/// A square of one material on the floor, and above it a smaller one that faces down.
void write_scene(const fs::path& folder, const std::string& floor, const std::string& above) {
    std::ofstream(folder / "scene.mtl") << "newmtl floor\n" << floor << "newmtl above\n" << above;
    std::ofstream(folder / "scene.obj") << "mtllib scene.mtl\n"
                                           "v -1 0 -1\nv -1 0 1\nv 1 0 1\nv 1 0 -1\n"
                                           "v -0.2 1 -0.2\nv 0.2 1 -0.2\nv 0.2 1 0.2\nv -0.2 1 0.2\n"
                                           "usemtl floor\nf 1 2 3 4\nusemtl above\nf 5 6 7 8\n";
}

Ended run_scene(const fs::path& folder, const std::string& scene) {
    return run_chapter("07_recursion", folder, "--quality draft --size 32 --samples 1 --scene " + scene);
}

}  // namespace

TEST_CASE(
    "chapter 7: a scene of one's own may have mirrors, glass and lamps, or none of them, and shows them") {
    const std::string     paint = "Kd 0.7 0.7 0.7\n", lamp = "Kd 0 0 0\nKe 9 9 9\n";
    const std::string     mirror = "illum 3\nKd 0 0 0\nKs 0.9 0.9 0.9\n", glass = "illum 4\nNi 1.5\n";
    std::set<std::string> pictures;
    for (const auto& [floor, above] :
         {std::pair{mirror, paint}, {glass, paint}, {paint, lamp}, {paint, paint}}) {
        CAPTURE(floor);
        CAPTURE(above);
        const ScratchFolder scratch{"recursion"};
        write_scene(scratch.path, floor, above);
        const Ended ended = run_scene(scratch.path, "scene.obj");
        CHECK(ended.code == 0);
        CHECK(ended.err == "");
        pictures.insert(read_text(scratch.path / "figures" / "07_recursion" / "scene.png"));
    }
    CHECK(pictures.size() == 4);
}

TEST_CASE("chapter 7: highlights that reflect too much are one line on stderr, and no error") {
    const ScratchFolder scratch{"recursion"};
    write_scene(scratch.path, "illum 2\nKd 0.75 0.75 0.75\nKs 0.5 0.5 0.5\nNs 60\n", "Kd 0.5 0.5 0.5\n");
    const Ended ended = run_scene(scratch.path, "scene.obj");
    CHECK(ended.code == 0);
    CHECK(ended.err ==
          "07_recursion: scene.mtl:1: material 'floor' reflects Kd + Ks = 1.25; both are divided by that\n");
}

TEST_CASE("chapter 7: a scene that can't be is refused before any section begins") {
    const ScratchFolder scratch{"recursion"};
    std::ofstream(scratch.path / "empty.obj") << "v 0 0 0\n";
    const Ended empty = run_scene(scratch.path, "empty.obj");
    CHECK(empty.code == 2);
    CHECK(empty.err == "07_recursion: error: empty.obj: has no faces; must have a line such as f 1 2 3\n");
    CHECK(empty.out == "Recursion\n");
    const Ended absent = run_scene(scratch.path, "absent.obj");
    CHECK(absent.code == 2);
    CHECK(absent.err == "07_recursion: error: --scene absent.obj: no such file; must be an OBJ file\n");
    CHECK(absent.out == "");
}
