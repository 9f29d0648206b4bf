/// @file light_transport_scene.cpp
/// Chapter 10 on scenes that a person brings along, to the error that is asked for, or until Ctrl-C.

#include <doctest/doctest.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <fstream>
#include <string>
#include <thread>

#include "chapter_checks.hpp"

using namespace sr::test;

namespace {

/// A square on the floor, and above it a smaller one that faces down.
void write_scene(const fs::path& folder, const std::string& above,
                 const std::string& floor = "Kd 0.7 0.7 0.7\n") {
    std::ofstream(folder / "scene.mtl") << "newmtl floor\n" << floor << "newmtl above\nKd 0 0 0\n" << above;
    std::ofstream(folder / "scene.obj") << "mtllib scene.mtl\n"
                                           "v -1 0 -1\nv -1 0 1\nv 1 0 1\nv 1 0 -1\n"
                                           "v -0.2 1 -0.2\nv 0.2 1 -0.2\nv 0.2 1 0.2\nv -0.2 1 0.2\n"
                                           "usemtl floor\nf 1 2 3 4\nusemtl above\nf 5 6 7 8\n";
}

}  // namespace

TEST_CASE("chapter 10: a scene in which nothing shines is refused before any section begins") {
    const ScratchFolder scratch{"light_transport_dark"};
    write_scene(scratch.path, "");
    const Ended dark =
        run_chapter("10_light_transport", scratch.path, "--quality draft --size 32 --scene scene.obj");
    CHECK(dark.code == 2);
    CHECK(
        dark.err ==
        "10_light_transport: error: scene.obj: nothing shines; must have faces of a material that does, such "
        "as Ke 10 10 10 in its .mtl file\n");
    CHECK(dark.out == "Light transport\n");
}

TEST_CASE("chapter 10: a scene whose lamps light nothing that is seen is refused before any section begins") {
    const ScratchFolder scratch{"light_transport_unlit"};
    write_scene(scratch.path, "Ke 9 9 9\n", "Kd 0 0 0\n");
    const Ended unlit =
        run_chapter("10_light_transport", scratch.path, "--quality draft --size 32 --scene scene.obj");
    CHECK(unlit.code == 2);
    CHECK(
        unlit.err ==
        "10_light_transport: error: scene.obj: no light arrives at what is seen; lamps must light what faces "
        "+z, whence it is seen, a little from above and from the right; y is up\n");
    CHECK(unlit.out == "Light transport\n");
}

TEST_CASE("chapter 10: Ctrl-C in the picture of a scene of one's own ends it with what it has, and says so") {
    const ScratchFolder scratch{"light_transport_interrupt"};
    write_scene(scratch.path, "Ke 9 9 9\n");
    const fs::path said = scratch.path / "said", folder = scratch.path / "figures" / "10_light_transport";
    const Ended    ended = in_child(
        [&] {
            const std::string line = "cd '" + scratch.path.string() + "' && exec '" +
                                     (build_folder / "bin" / "10_light_transport").string() +
                                     "' --quality draft --size 64 --scene scene.obj --error 0.001 >said";
            return ::execl("/bin/sh", "sh", "-c", line.c_str(), nullptr);
        },
        [&](pid_t child) {
            const auto rendering = [&] {
                return fs::exists(said) && read_text(said).find("\n10.10 ") != std::string::npos;
            };
            while (!rendering() && runs(child)) std::this_thread::sleep_for(std::chrono::milliseconds(20));
            std::this_thread::sleep_for(std::chrono::milliseconds(200));
            ::kill(child, SIGINT);
        });
    CHECK(ended.code == 130);
    CHECK(ended.err.find("10_light_transport: interrupted: ") == 0);
    CHECK(error_lines(ended) == 1);
    CHECK(read_text(said).find("asked for 0.001, interrupted\n") != std::string::npos);
    CHECK(read_text(folder / "captions.csv").find("asked for 0.001, interrupted.") != std::string::npos);
    CHECK(fs::file_size(folder / "to_error.png") > 0);
    CHECK(fs::file_size(folder / "to_error.hdr") > 0);
    for (const auto& entry : fs::directory_iterator(folder))
        CHECK(entry.path().filename().string().front() != '.');
}
