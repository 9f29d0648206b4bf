/// @file far_from_the_origin.cpp
/// A float has as many digits far away as near: vertices that are rounded there lose the picture.

#include <doctest/doctest.h>

#include "geometry/hierarchy.hpp"
#include "scene/camera.hpp"
#include "scene/teapot.hpp"
#include "transport/primary.hpp"

using namespace sr;

namespace {

struct View {
    Mesh<double>   mesh;
    Camera<double> camera;
};

/// A teapot and its camera, moved together by so many units along the diagonal.
View moved(double distance) {
    constexpr Vector3<double> eye{2.6, -8.2, 4.2}, target{0.2, 0, 1.45};
    View view{teapot(8), pinhole_camera<double>(eye, target - eye, {0, 0, 1}, 1.0, 0.82, 128, 128)};
    for (auto& vertex : view.mesh.vertices) vertex += Vector3<double>(distance);
    view.camera.position += Vector3<double>(distance);
    return view;
}

View in_camera_space(const View& view) {
    return {to_camera_space(view.mesh, view.camera), sr::in_camera_space(view.camera)};
}

template <class T>
VisibilityImage<T> seen(const View& view) {
    return trace_primary(Hierarchy<T>(convert<T>(view.mesh)), convert<T>(view.camera));
}

/// The share of pixels in which float sees another triangle than double sees near the origin [%].
double wrong(const View& view) {
    const auto image = seen<float>(view);
    const auto exact = seen<double>(moved(0));
    int        count = 0;
    for (std::size_t i = 0; i < exact.pixels().size(); ++i)
        count += image.pixels()[i].face != exact.pixels()[i].face ? 1 : 0;
    return 100.0 * count / double(exact.pixels().size());
}

}  // namespace

TEST_CASE("far from the origin a picture is lost in world space, and none of it in camera space") {
    CHECK(wrong(moved(0)) <= 0.1);  // pixels whose centre is on an edge
    for (const auto& [distance, at_least] : {std::pair{1e4, 0.1}, {1e5, 0.5}, {1e6, 5.0}, {1e7, 15.0}}) {
        CAPTURE(distance);
        CHECK(wrong(moved(distance)) >= at_least);
        CHECK(wrong(in_camera_space(moved(distance))) == 0);
    }
}
