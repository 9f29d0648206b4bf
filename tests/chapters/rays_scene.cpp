/// @file rays_scene.cpp
/// Chapter 1 on scenes that a person brings along.

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <fstream>

#include "run_course.hpp"

using namespace sr::test;

namespace {

/// Faces whose three corners lie on one line, along each axis in turn, spread evenly over a cube.
void write_lines(const fs::path& file, int count) {
    std::ofstream obj(file);
    const auto    spread = [](int i, double step) { return std::fmod(i * step, 1.0) * 2 - 1; };
    for (int i = 0; i < count; ++i) {
        for (const double along : {-1.0, spread(i, 0.5698403), 1.0}) {
            std::array<double, 3> v{spread(i, 0.6180340), spread(i, 0.7548777), spread(i, 0.8191725)};
            v[std::size_t(i) % 3] = along;
            obj << "v " << v[0] << ' ' << v[1] << ' ' << v[2] << '\n';
        }
        obj << "f -3 -2 -1\n";
    }
}

}  // namespace

TEST_CASE("chapter 1: faces without area, some of which rounding to float makes visible, spoil no picture") {
    const ScratchFolder scratch{"rays"};
    write_lines(scratch.path / "lines.obj", 20'000);
    const Ended ended =
        run_shell(scratch.path, "'" + (build_folder / "bin" / "01_rays").string() +
                                    "' --quality draft --size 32 --samples 64 --scene lines.obj");
    CHECK(ended.code == 0);
    CHECK(ended.err == "");  // nor is it said that the pictures are blank
}
