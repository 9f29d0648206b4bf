/// @file scene_view.cpp
/// What a file's scene is lit by.

#include <doctest/doctest.h>

#include <cmath>
#include <fstream>
#include <string>

#include "scene/scene_view.hpp"
#include "scratch_folder.hpp"
#include "transport/recursion.hpp"

using namespace sr;

namespace {

/// A sheet of white paper and, beside it, a triangle of another material.
SceneView view_of_sheets(const std::string& behind) {
    const test::ScratchFolder scratch{"scene_view"};
    std::ofstream(scratch.path / "sheets.mtl") << "newmtl paper\nKd 1 1 1\nnewmtl behind\n" << behind;
    std::ofstream(scratch.path / "sheets.obj") << "mtllib sheets.mtl\n"
                                                  "v -4 0 -3\nv 4 0 3\nv 0 8 -10\nv 0 -8 10\n"
                                                  "usemtl paper\nf 1 4 2 3\n"
                                                  "v -4 -1 -3\nv 4 -1 3\nv 0 7 -10\n"
                                                  "usemtl behind\nf 5 6 7\n";
    return lit_view_of_file(scratch.path / "sheets.obj", 8);
}

}  // namespace

TEST_CASE("scene view: what has no lamp is lit from the upper left, and white paper there has radiance 1") {
    SceneView view = view_of_sheets("Kd 0.5 0.5 0.5\n");
    REQUIRE(view.scene.lights.size() == 1);
    const Vector3<double> at = view.scene.lights[0].position();
    CHECK(at.x < 0);
    CHECK(at.y > 0);

    // paper in the origin that faces the light
    view.scene.mesh               = {};
    view.scene.material_of_face   = {};
    view.scene.balls              = {{{-1e-3 * normalize(at), 1e-3}, 0}};
    const Vec3            towards = normalize(Vec3(at));
    Rng                   rng{1, 0, 0, 0};
    RayCount              count;
    const RecursiveTracer tracer(view.scene);
    const Spectrum        L = tracer.radiance({towards, -towards}, rng, count);
    CHECK(std::abs(L.g - 1) <= 1e-4F);
    CHECK(tracer.radiance({towards, towards}, rng, count) == view.scene.background);
    CHECK(each_in(view.scene.background, 0.01F, 0.2F));
}

TEST_CASE(
    "scene view: lamps, if there are any, are its lights, where and as large as the view has moved them") {
    const SceneView view = view_of_sheets("Ke 3 2 1\n");
    REQUIRE(view.scene.lights.size() == 1);
    const auto& mesh = view.scene.mesh;
    for (std::size_t i = 0; i < mesh.faces.size(); ++i) {
        if (view.scene.materials[view.scene.material_of_face[i]].name != "behind") continue;
        const auto [a, b, c] = mesh.triangle(i);
        CHECK(length(view.scene.lights[0].position() - (a + b + c) / 3.0) <= 1e-12);
        CHECK(std::abs(view.scene.lights[0].intensity().r / (3 * float(area(mesh.triangle(i)))) - 1) <=
              1e-6F);
    }
}
