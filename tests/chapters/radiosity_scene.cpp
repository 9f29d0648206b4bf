/// @file radiosity_scene.cpp
/// Chapter 8 on scenes that a person brings along.

#include <doctest/doctest.h>

#include <algorithm>
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
    CHECK(mirror.err ==
          "08_radiosity: error: scene.obj: material 'floor' is not diffuse, and radiosity knows no "
          "directions; make it "
          "illum 1, or trace rays\n");
}

TEST_CASE("chapter 8: a scene without an area, or with more faces than pairs can be taken of, is refused") {
    const ScratchFolder scratch{"radiosity"};
    const auto          run = [&](const std::string& obj) {
        std::ofstream(scratch.path / "scene.obj") << obj;
        return run_chapter("08_radiosity", scratch.path, "--quality draft --size 32 --scene scene.obj");
    };
    const Ended flat = run("v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\n");
    CHECK(flat.code == 2);
    CHECK(flat.err == "08_radiosity: error: scene.obj: no face has an area\n");
    std::string triangles = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
    for (int i = 0; i < 2001; ++i) triangles += "f 1 2 3\n";
    const Ended many = run(triangles);
    CHECK(many.code == 2);
    CHECK(many.err ==
          "08_radiosity: error: scene.obj: it has 2001 faces; must be 2000 at most, for each pair has a "
          "form factor\n");
}

TEST_CASE("chapter 8: a closed room that reflects all light is refused, and the material's Kd named") {
    const ScratchFolder scratch{"radiosity"};
    std::ofstream(scratch.path / "scene.mtl") << "newmtl lamp\nKd 1 1 1\nKe 1 1 1\nnewmtl snow\nKd 1 1 1\n";
    std::ofstream(scratch.path / "scene.obj") << "mtllib scene.mtl\n"
                                                 "v 0 0 0\nv 1 0 0\nv 1 0 1\nv 0 0 1\n"
                                                 "v 0 1 0\nv 1 1 0\nv 1 1 1\nv 0 1 1\n"
                                                 "usemtl lamp\nf 5 6 7 8\nusemtl snow\nf 4 3 2 1\n"
                                                 "f 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n";
    const Ended white =
        run_chapter("08_radiosity", scratch.path, "--quality draft --size 32 --scene scene.obj");
    CHECK(white.code == 2);
    CHECK(white.err.ends_with("(Kd is 1 in 'lamp' 'snow')\n"));
    CHECK(std::count(white.err.begin(), white.err.end(), '\n') == 1);
}
