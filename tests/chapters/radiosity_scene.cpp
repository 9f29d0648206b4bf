/// @file radiosity_scene.cpp
/// Chapter 8 on scenes that a person brings along.

#include <doctest/doctest.h>

#include <fstream>
#include <string>

#include "chapter_checks.hpp"

using namespace sr::test;

namespace {

/// A square of one material on the floor, and above it a smaller one that faces down.
Ended run_scene(const fs::path& folder, const std::string& floor, const std::string& above) {
    std::ofstream(folder / "scene.mtl") << "newmtl floor\n" << floor << "newmtl above\n" << above;
    std::ofstream(folder / "scene.obj") << "mtllib scene.mtl\n"
                                           "v -1 0 -1\nv -1 0 1\nv 1 0 1\nv 1 0 -1\n"
                                           "v -0.2 1 -0.2\nv 0.2 1 -0.2\nv 0.2 1 0.2\nv -0.2 1 0.2\n"
                                           "usemtl floor\nf 1 2 3 4\nusemtl above\nf 5 6 7 8\n";
    return run_chapter("08_radiosity", folder, "--quality draft --size 32 --scene scene.obj");
}

}  // namespace

TEST_CASE("chapter 8: a scene of one's own is shown if it is diffuse and something in it shines") {
    const ScratchFolder scratch{"radiosity"};
    const Ended         ended = run_scene(scratch.path, "Kd 0.7 0.7 0.7\n", "Kd 0 0 0\nKe 9 9 9\n");
    CHECK(ended.code == 0);
    CHECK(ended.err == "");
    CHECK(fs::exists(scratch.path / "figures" / "08_radiosity" / "scene.png"));
}

TEST_CASE("chapter 8: what radiosity can't do is refused in one line, before any section begins") {
    const ScratchFolder scratch{"radiosity"};
    const Ended         dark = run_scene(scratch.path, "Kd 0.7 0.7 0.7\n", "Kd 0.1 0.1 0.1\n");
    CHECK(dark.code == 2);
    CHECK(dark.err ==
          "08_radiosity: error: scene.obj: nothing shines, and all is black; must have a material with Ke "
          "above "
          "0\n");
    CHECK(dark.out == "Radiosity\n");
    const Ended mirror =
        run_scene(scratch.path, "illum 3\nKd 0 0 0\nKs 0.9 0.9 0.9\n", "Kd 0 0 0\nKe 9 9 9\n");
    CHECK(mirror.code == 2);
    CHECK(
        mirror.err ==
        "08_radiosity: error: scene.obj: material 'floor' is not diffuse, and radiosity knows no directions; trace rays "
        "instead\n");
}
