#include "scene/camera.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <tuple>

#include "math/degrees.hpp"
#include "math/extremes.hpp"
#include "scene/cornell_box.hpp"

using namespace sr;

TEST_CASE("the Cornell box's camera sees the published field of view, corner to corner") {
    const auto camera = cornell_box_camera(640);
    CHECK(std::abs(degrees(field_of_view(camera, camera.width)) - 39.307648) <= 5e-7);
    for (const auto& [x, y, side, upwards] :
         {std::tuple{0.0, 0.0, 1, 1}, {640.0, 0.0, -1, 1}, {0.0, 640.0, 1, -1}, {640.0, 640.0, -1, -1}}) {
        const auto d = camera.ray({x, y}).direction;
        // Looking along z with y up, the image's left is at large x: where the red wall is.
        CHECK(std::abs(degrees(std::atan2(d.x, d.z)) - side * 39.307648 / 2) <= 5e-7);
        CHECK(std::abs(degrees(std::atan2(d.y, d.z)) - upwards * 39.307648 / 2) <= 5e-7);
    }
}

TEST_CASE("pixels are square, whatever the image's shape") {
    const auto wide = pinhole_camera<double>({0, 0, 0}, {0, 0, 1}, {0, 1, 0}, 1.4, 1.0, 640, 320);
    CHECK(std::abs(std::tan(field_of_view(wide, 320) / 2) * 2 - std::tan(field_of_view(wide, 640) / 2)) <=
          1e-15);
}

TEST_CASE_TEMPLATE("projection and ray are inverse", T, float, double) {
    const auto camera =
        convert<T>(pinhole_camera<double>({4, -7, 4.5}, {-4, 7, -3}, {0, 0, 1}, 1.0, 0.8, 640, 480));
    double worst = 0;
    for (int y = 0; y < camera.height; y += 13) {
        for (int x = 0; x < camera.width; x += 17) {
            for (const T t : {T(1e-3), T(1), T(50)}) {
                const auto image = camera.project(camera.ray_through_pixel(x, y).at(t));
                REQUIRE(image);
                worst =
                    max_or_nan(worst, length(Vector2<double>(*image) - Vector2<double>(x + 0.5, y + 0.5)));
            }
        }
    }
    CHECK(worst <= 6000.0 * std::numeric_limits<T>::epsilon());  // [pixel], at coordinates up to 640
    CHECK(!camera.project(camera.position - camera.forward));
    CHECK(!camera.project(camera.position));
}

TEST_CASE("t counts the depth in units of the image plane's distance") {
    const auto camera = cornell_box_camera(64);
    for (const int pixel : {0, 20, 63}) {
        const auto p = camera.ray_through_pixel(pixel, 5).at(3.0);
        CHECK(std::abs(camera.to_camera(p).z - 3.0 * camera.plane_distance) <= 1e-12);
    }
}

TEST_CASE("a scene in camera space looks the same") {
    const auto camera = cornell_box_camera(64);
    const auto moved  = in_camera_space(camera);
    const auto world  = cornell_box().mesh;
    const auto mesh   = to_camera_space(world, camera);
    for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
        const auto there = camera.project(world.vertices[i]);
        const auto here  = moved.project(mesh.vertices[i]);
        REQUIRE(there);
        REQUIRE(here);
        CHECK(length(*there - *here) <= 1e-12);
    }
}
